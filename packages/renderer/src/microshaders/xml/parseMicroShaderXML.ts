import type { MicroShader, MicroShaderStage } from '../MicroShader';
import { completeMicroShader } from '../parseMicroShader';
import { shortText } from '../shortText';
import { parseXML, type XMLElement } from './parseXML';

const ATTRIBUTES = ['name', 'stage', 'dependencies'];

/**
 * Parses the thesis's file of microshaders:
 * `<microshaders><microshader name="…" dependencies="a b" stage="fragment"><header>…</header><main>…</main></microshader>…`.
 * `dependencies` (separated by blanks), `stage`, header and main are optional; `<maincode>`, the thesis's name for main, is
 * accepted.
 * @param file - name of the file, for errors
 * @throws Error with file and line for malformed XML, unknown elements or attributes, missing and duplicate names
 * @see thesis 3.1.2 and 3.2.6
 */
export function parseMicroShaderXML(text: string, file: string): MicroShader[] {
  const root = parseXML(text, file);
  if (root.name !== 'microshaders') fail(file, root, `the root is <${shortText(root.name)}>, not <microshaders>`);
  noText(file, root);
  const chunks = new Map<string, MicroShader>();
  for (const element of root.children) {
    if (element.name !== 'microshader')
      fail(file, element, `<${shortText(element.name)}> where only <microshader> may be`);
    const chunk = microShaderOf(file, element);
    if (chunks.has(chunk.name)) fail(file, element, `a second microshader named "${shortText(chunk.name)}"`);
    chunks.set(chunk.name, chunk);
  }
  return [...chunks.values()];
}

function microShaderOf(file: string, element: XMLElement): MicroShader {
  const { name, stage, dependencies = '' } = element.attributes;
  const stray = Object.keys(element.attributes).find((key) => !ATTRIBUTES.includes(key));
  if (stray) fail(file, element, `attribute "${shortText(stray)}" is unknown; there are ${ATTRIBUTES.join(', ')}`);
  if (!name) fail(file, element, '<microshader> without a name');
  noText(file, element);
  const parts: Partial<Record<'header' | 'main', XMLElement>> = {};
  for (const child of element.children) {
    const part = child.name === 'maincode' ? 'main' : child.name;
    if (part !== 'header' && part !== 'main')
      return fail(
        file,
        child,
        `<${shortText(child.name)}> in microshader "${shortText(name)}"; there are <header> and <main>`,
      );
    if (parts[part]) fail(file, child, `a second <${shortText(child.name)}> in microshader "${shortText(name)}"`);
    if (child.children.length > 0)
      fail(
        file,
        child.children[0],
        `<${shortText(child.children[0].name)}> in the code of "${shortText(name)}"; use <![CDATA[ … ]]>`,
      );
    parts[part] = child;
  }
  try {
    return completeMicroShader({
      name,
      header: parts.header?.text ?? '',
      main: parts.main?.text ?? '',
      ...(stage !== undefined && { stage: stage as MicroShaderStage }),
      dependencies: dependencies.split(/\s+/).filter(Boolean),
      headerLine: parts.header?.textLine ?? 1,
      mainLine: parts.main?.textLine ?? 1,
    });
  } catch (error) {
    return fail(file, element, (error as Error).message);
  }
}

function noText(file: string, element: XMLElement): void {
  if (element.text.trim() !== '')
    fail(file, element, `text directly inside <${element.name}>: "${element.text.trim().slice(0, 20)}"`);
}

function fail(file: string, element: XMLElement, message: string): never {
  throw new Error(`${shortText(file)}:${element.line}: ${shortText(message, 240)}`);
}
