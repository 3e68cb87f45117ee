/**
 * Shows a LaTeX formula as MathML, which browsers draw and screen readers read. The library is loaded with the first
 * formula.
 */
export async function showFormula(element: HTMLElement, latex: string): Promise<void> {
  if (element.dataset.latex === latex) return;
  element.dataset.latex = latex;
  const { default: temml } = await import("temml");
  // A newer formula may have arrived while the library was loading.
  if (element.dataset.latex === latex) temml.render(latex, element, { displayMode: false, throwOnError: false });
}
