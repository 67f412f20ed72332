import { classNameOf, isJavaScript, typeNameOf } from './scriptNames';

/** What a new script begins with: a class of components with one field. */
export function scriptTemplate(script: string): string {
  const name = classNameOf(script);
  const typed = (text: string): string => (isJavaScript(script) ? '' : text);
  return `import { component, number } from '@farol/engine/fields';

/** Turns its object while the scene plays. */
export default class ${name} extends component({
  speed: number(1, { unit: 'rad/s', help: 'How fast it turns.' }),
}) {
  static ${typed('override readonly ')}typeName${typed(': string')} = '${name}';

  /** Once, before the first update. */
  ${typed('override ')}start()${typed(': void')} {}

  /** Each frame; deltaSeconds is the time since the last one. */
  ${typed('override ')}update(deltaSeconds${typed(': number')})${typed(': void')} {
    this.gameObject.object3D.rotateY(this.speed * deltaSeconds);
  }
}
`;
}

/** The text of a script under another name: its class and its type of components are called after that, too. */
export function sourceForName(source: string, script: string): string {
  const before = typeNameOf(source);
  if (before === null) return source;
  const after = classNameOf(script);
  const word = before.replaceAll('$', String.raw`\$`);
  return source
    .replace(
      new RegExp(String.raw`(\bexport\s+default\s+class\s+)${word}(?![\w$])`),
      (_all, start: string) => start + after,
    )
    .replace(
      new RegExp(String.raw`(\btypeName\b[^;=]*=\s*)(['"\`])${word}\2`),
      (_all, start: string, quote: string) => start + quote + after + quote,
    );
}
