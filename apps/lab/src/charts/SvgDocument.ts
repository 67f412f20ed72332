const SVG = 'http://www.w3.org/2000/svg';

/**
 * An element without a browser: as much of the DOM as Observable Plot asks of the elements that it makes, and a text of
 * it.
 */
export class SvgNode {
  readonly namespaceURI = SVG;
  readonly attributes = new Map<string, string>();
  readonly children: (SvgNode | string)[] = [];
  readonly style = new SvgStyle();

  constructor(
    readonly ownerDocument: SvgDocument,
    readonly tagName: string,
  ) {}

  setAttribute(name: string, value: unknown): void {
    this.attributes.set(name, String(value));
  }

  setAttributeNS(_space: string, name: string, value: unknown): void {
    this.attributes.set(name, String(value));
  }

  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }

  removeAttribute(name: string): void {
    this.attributes.delete(name);
  }

  appendChild<T extends SvgNode | string>(child: T): T {
    this.children.push(child);
    return child;
  }

  append(...children: (SvgNode | string)[]): void {
    this.children.push(...children);
  }

  insertBefore<T extends SvgNode | string>(child: T, before: SvgNode | string | null): T {
    const place = before === null ? -1 : this.children.indexOf(before);
    this.children.splice(place === -1 ? this.children.length : place, 0, child);
    return child;
  }

  set textContent(text: string | null) {
    this.children.splice(0, this.children.length, ...(text ? [text] : []));
  }

  get textContent(): string {
    return this.children.map((child) => (typeof child === 'string' ? child : child.textContent)).join('');
  }

  /** The element as SVG text. */
  get outerHTML(): string {
    const style = this.style.toString();
    const attributes = [...this.attributes, ...(style ? [['style', style]] : [])].map(
      ([name, value]) => ` ${name}="${escape(value).replaceAll('"', '&quot;')}"`,
    );
    const inner = this.children.map((child) => (typeof child === 'string' ? escape(child) : child.outerHTML)).join('');
    return inner === ''
      ? `<${this.tagName}${attributes.join('')}/>`
      : `<${this.tagName}${attributes.join('')}>${inner}</${this.tagName}>`;
  }
}

/** Styles of an element, set by method or by name. */
class SvgStyle {
  setProperty(name: string, value: string): void {
    (this as unknown as Record<string, string>)[name] = value;
  }

  removeProperty(name: string): void {
    delete (this as unknown as Record<string, string>)[name];
  }

  toString(): string {
    return Object.entries(this)
      .map(([name, value]) => `${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}:${value}`)
      .join(';');
  }
}

/** A document that makes {@link SvgNode}s: charts are drawn by it for files, in a page as in Node. */
export class SvgDocument {
  readonly documentElement = new SvgNode(this, 'svg');

  createElementNS(_space: string, name: string): SvgNode {
    return new SvgNode(this, name);
  }

  createElement(name: string): SvgNode {
    return new SvgNode(this, name);
  }

  createTextNode(text: string): string {
    return text;
  }
}

function escape(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
}
