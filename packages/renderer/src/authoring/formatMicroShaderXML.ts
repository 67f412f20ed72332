import type { MicroShader } from '../microshaders';

const quoted = (value: string): string =>
  `"${value.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;')}"`;

/** Text as CDATA, split where it contains the end of a section. */
const cdata = (text: string): string => `<![CDATA[${text.replaceAll(']]>', ']]]]><![CDATA[>')}]]>`;

/** Formats microshaders as an XML file of the thesis, which `parseMicroShaderXML` reads back. @see thesis 3.2.6 */
export function formatMicroShaderXML(chunks: readonly MicroShader[]): string {
  const elements = chunks.map(({ name, stage, dependencies, header, main }) => {
    const attributes = [
      `name=${quoted(name)}`,
      ...(stage === undefined ? [] : [`stage=${quoted(stage)}`]),
      ...(dependencies.length > 0 ? [`dependencies=${quoted(dependencies.join(' '))}`] : []),
    ];
    const part = (tag: string, text: string): string => (text === '' ? '' : `    <${tag}>${cdata(text)}</${tag}>\n`);
    return `  <microshader ${attributes.join(' ')}>\n${part('header', header)}${part('main', main)}  </microshader>\n`;
  });
  return `<?xml version="1.0" encoding="UTF-8"?>\n<microshaders>\n${elements.join('\n')}</microshaders>\n`;
}
