import type { MicroShader } from './microshaders/MicroShader';
import { parseMicroShader } from './microshaders/parseMicroShader';
import * as gbuffer from './gbuffer/chunks';
import * as gpu from './gpu/chunks';
import * as lighting from './lighting/chunks';
import * as lists from './lighting/lists/chunks';
import * as loops from './lighting/loops/chunks';
import * as shading from './lighting/shading/chunks';
import * as volumes from './lighting/volumes/chunks';
import * as output from './output/chunks';

/** Sources by name: a new microshader is a file, and a line in the `chunks.ts` of its folder. */
const sources = { ...gbuffer, ...gpu, ...lighting, ...lists, ...loops, ...shading, ...volumes, ...output };

export type BuiltinMicroShader = keyof typeof sources;

export const builtinMicroShaders: readonly MicroShader[] = Object.entries(sources).map(([name, text]) =>
  parseMicroShader(name, text),
);
