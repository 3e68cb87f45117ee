import { vi } from "vitest";

/** A substitute for an element of a page: attributes, children and events, and nothing that is drawn. */
export class FakeElement extends EventTarget {
  readonly attributes = new Map<string, string>();
  readonly children: FakeElement[] = [];
  readonly style = { cssText: "" };
  parent: FakeElement | null = null;
  shadowRoot: FakeElement | null = null;
  activeElement: FakeElement | null = null;
  hidden = false;
  textContent = "";
  innerHTML = "";
  tag = "";
  onclick: (() => void) | null = null;
  /** Of a frame: the messages that its page got. */
  readonly posted: { message: unknown; origin: string }[] = [];
  readonly contentWindow = { postMessage: (message: unknown, origin: string) => void this.posted.push({ message, origin }) };

  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }

  setAttribute(name: string, value: string): void {
    const before = this.getAttribute(name);
    this.attributes.set(name, value);
    if (name === "hidden") this.hidden = true;
    const own = this as unknown as { attributeChangedCallback?: (name: string, before: string | null, value: string) => void };
    const { observedAttributes = [] } = this.constructor as unknown as { observedAttributes?: string[] };
    if (observedAttributes.includes(name)) own.attributeChangedCallback?.(name, before, value);
  }

  removeAttribute(name: string): void {
    this.attributes.delete(name);
  }

  append(...added: FakeElement[]): void {
    for (const one of added) [one.parent, this.children[this.children.length]] = [this, one];
  }

  prepend(...added: FakeElement[]): void {
    for (const one of added) one.parent = this;
    this.children.unshift(...added);
  }

  remove(): void {
    this.parent?.children.splice(this.parent.children.indexOf(this), 1);
  }

  attachShadow(): FakeElement {
    return (this.shadowRoot = new FakeElement());
  }

  matches(): boolean {
    return false;
  }

  focus(): void {}

  /** Returns the elements of a tag within this one. */
  all(tag: string): FakeElement[] {
    return [...this.children, ...(this.shadowRoot ? [this.shadowRoot] : [])].flatMap((one) => [...(one.tag === tag ? [one] : []), ...one.all(tag)]);
  }
}

/** Gives the element's script a page with this address; returns what the page's window and its observers hear. */
export function fakePage(baseURI: string) {
  const heard = new Set<(event: unknown) => void>();
  const seen: ((entries: unknown[]) => void)[] = [];
  vi.stubGlobal("HTMLElement", FakeElement);
  vi.stubGlobal("navigator", { languages: ["en"] });
  vi.stubGlobal("customElements", { get: () => undefined, define: () => undefined });
  vi.stubGlobal("document", {
    baseURI,
    currentScript: null,
    createElement: (tag: string) => Object.assign(new FakeElement(), { tag }),
  });
  vi.stubGlobal("addEventListener", (_type: string, hear: (event: unknown) => void) => heard.add(hear));
  vi.stubGlobal("removeEventListener", (_type: string, hear: (event: unknown) => void) => heard.delete(hear));
  vi.stubGlobal("IntersectionObserver", class {
    constructor(see: (entries: unknown[]) => void) {
      seen.push(see);
    }
    observe(): void {}
    disconnect(): void {}
  });
  return {
    heard,
    hear: (event: unknown) => heard.forEach((hear) => hear(event)),
    see: (entry: { intersectionRatio: number; isIntersecting: boolean }) => seen.at(-1)!([entry]),
  };
}
