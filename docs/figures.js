// Loads the element that plays figures, where a server serves the page: from a folder, a browser runs no engine.
const figure = document.querySelector("kingpost-figure[src]");
if (figure && location.protocol !== "file:") {
  const script = document.createElement("script");
  script.src = new URL("kingpost-figure.js", new URL(figure.getAttribute("src"), document.baseURI)).href;
  document.head.append(script);
}
