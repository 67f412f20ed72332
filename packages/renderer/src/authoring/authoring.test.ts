import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { builtinMicroShaders } from './builtinMicroShaders';
import { type MicroShader, parseMicroShader } from '../microshaders';
import { formatMicroShaderXML, parseMicroShaderXML } from '.';
import { microShaderSources } from './microShaderSources';

const content = ({ headerLine: _h, mainLine: _m, ...chunk }: MicroShader): Partial<MicroShader> => chunk;

it('writes XML that is read as the same chunks', () => {
  const thesis = parseMicroShaderXML(
    readFileSync(new URL('../../../../public/microshaders/thesis.xml', import.meta.url), 'utf8'),
    'thesis.xml',
  );
  const odd = parseMicroShader('odd', '//# stage vertex\n// a ]]> b & <c>\n//# main\nx = 1.0;');
  for (const chunks of [thesis, [odd], builtinMicroShaders]) {
    const again = parseMicroShaderXML(formatMicroShaderXML(chunks), 'written.xml');
    expect(again.map(content)).toEqual(chunks.map(content));
  }
});

it('has every built-in chunk as it was written', () => {
  expect(Object.keys(microShaderSources).toSorted()).toEqual(builtinMicroShaders.map(({ name }) => name).toSorted());
  for (const chunk of builtinMicroShaders)
    expect(parseMicroShader(chunk.name, microShaderSources[chunk.name])).toEqual(chunk);
});
