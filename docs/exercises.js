// Exercises of the book check their answers in the page; without this script the answers are still there, folded.
for (const form of document.querySelectorAll("form.exercise")) {
  const { kind, answer, tolerance } = form.dataset;
  const number = (text) => Number(text.trim().replace(",", ".").replace("−", "-") || NaN);
  const same = (given, wanted) =>
    kind === "number" ? Math.abs(number(given) - Number(wanted)) <= Number(tolerance) : given === wanted;
  const said = [...form.querySelectorAll("[role=status] > p")];
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const given = new FormData(form).get("answer") ?? "";
    const right = said.find((one) => "right" in one.dataset);
    const known = said.find((one) => "when" in one.dataset && same(given, one.dataset.when));
    const shown = same(given, answer) ? right : (known ?? said.find((one) => "other" in one.dataset));
    for (const one of said) one.hidden = one !== shown;
    form.dataset.result = shown === right ? "right" : "wrong";
  });
}
