import { shortText } from '../shortText';

export interface XMLElement {
  readonly name: string;
  readonly attributes: Readonly<Record<string, string>>;
  readonly children: XMLElement[];
  /** All text directly inside the element, CDATA included. */
  text: string;
  /** Line of the opening tag, and of its end, from 1. */
  readonly line: number;
  readonly textLine: number;
}

const NAME = '[A-Za-z_][\\w.:-]*';
const ATTRIBUTE = `(${NAME})\\s*=\\s*("[^"<]*"|'[^'<]*')`;
const TOKEN = new RegExp(
  [
    '<!--(?:(?!--)[^])*-->',
    '<!\\[CDATA\\[(?<data>[^]*?)\\]\\]>',
    '<\\?(?!xml\\s)[^]*?\\?>',
    `</(?<close>${NAME})\\s*>`,
    `<(?<open>${NAME})(?<attributes>(?:\\s+${ATTRIBUTE.replaceAll(/\((?!\?)/g, '(?:')})*)\\s*(?<empty>/?)>`,
    '(?<text>[^<]+)',
  ].join('|'),
  'y',
);
const DECLARATION = /^<\?xml(?:\s+[a-z]+\s*=\s*(?:"[\w.-]*"|'[\w.-]*'))+\s*\?>/;
const ENTITIES: Record<string, string> = { lt: '<', gt: '>', amp: '&', quot: '"', apos: "'" };

/**
 * Parses XML 1.0 without a document type: elements, attributes, text, CDATA, comments, character references. Own code, because
 * `DOMParser` is missing in Node, and has no lines of elements in browsers.
 * @param file - name of the file, for errors
 * @throws Error with file and line, if not well formed
 * @see https://www.w3.org/TR/xml/
 */
export function parseXML(text: string, file: string): XMLElement {
  const xml = text.replace(/^\uFEFF/, '').replace(/\r\n?/g, '\n');
  let line = 1;
  const fail = (message: string, before = ''): never => {
    throw new Error(`${shortText(file)}:${line + newlines(before)}: ${shortText(message, 240)}`);
  };
  const unescaped = (value: string): string =>
    value.replace(/&([^;\s&]*)(;?)/g, (whole, reference: string, end: string, offset: number) => {
      const code = /^#(?:x([\da-fA-F]+)|(\d+))$/.exec(reference);
      const point = code ? Number.parseInt(code[1] ?? code[2], code[1] ? 16 : 10) : 0;
      if (end && point > 0 && point <= 0x10ffff) return String.fromCodePoint(point);
      if (end && Object.hasOwn(ENTITIES, reference)) return ENTITIES[reference];
      return fail(
        `"${shortText(whole)}" is not an entity; write "&amp;" for "&", or use <![CDATA[ … ]]>`,
        value.slice(0, offset),
      );
    });
  const stack: XMLElement[] = [];
  let root: XMLElement | undefined;
  const append = (value: string) => {
    const parent = stack.at(-1);
    if (parent) parent.text += value;
    else if (value.trim() !== '') fail('text is outside the root element; move it inside', /^\s*/.exec(value)![0]);
  };
  const open = (name: string, attributes: string, end: number): XMLElement => {
    const values: Record<string, string> = {};
    for (const [, key, quoted] of attributes.matchAll(new RegExp(ATTRIBUTE, 'g'))) {
      if (Object.hasOwn(values, key)) fail(`attribute "${shortText(key)}" is twice in <${shortText(name)}>; leave one`);
      values[key] = unescaped(quoted.slice(1, -1).replace(/\s/g, ' '));
    }
    const element = { name, attributes: values, children: [], text: '', line, textLine: end };
    if (stack.length > 0) stack.at(-1)!.children.push(element);
    else if (root) fail(`<${shortText(name)}> is a second root element; put all into one`);
    root ??= element;
    return element;
  };

  const declaration = DECLARATION.exec(xml)?.[0] ?? '';
  line += newlines(declaration);
  TOKEN.lastIndex = declaration.length;
  while (TOKEN.lastIndex < xml.length) {
    const at = TOKEN.lastIndex;
    const match = TOKEN.exec(xml);
    if (match === null)
      return fail(`"${xml.slice(at, at + 20).split('\n')[0]}" is not XML; put GLSL into <![CDATA[ … ]]>`);
    const { data, close, open: name, attributes, empty, text: plain } = match.groups!;
    const end = line + newlines(match[0]);
    if (name !== undefined) {
      const element = open(name, attributes, end);
      if (empty === '') stack.push(element);
    } else if (close !== undefined) {
      const opened = stack.pop() ?? fail(`</${shortText(close)}> closes nothing; take it out`);
      if (opened.name !== close)
        fail(
          `</${shortText(close)}> does not close <${shortText(opened.name)}> of line ${opened.line}; write </${shortText(opened.name)}>`,
        );
    } else if (data !== undefined) {
      if (stack.length === 0) fail('CDATA is outside the root element; move it inside');
      append(data);
    } else if (plain !== undefined) {
      if (plain.includes(']]>')) fail('"]]>" closes nothing; write <![CDATA[ before it');
      append(unescaped(plain));
    }
    line = end;
  }
  if (stack.length > 0)
    fail(`<${shortText(stack.at(-1)!.name)}> of line ${stack.at(-1)!.line} is never closed; close it`);
  return root ?? fail('the file has no root element; write one');
}

function newlines(text: string): number {
  return text.split('\n').length - 1;
}
