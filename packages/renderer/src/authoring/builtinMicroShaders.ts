import { coreSources } from '../renderer/coreSources';
import * as lists from '../techniques/light-lists/chunks';
import type { MicroShader } from '../microshaders/MicroShader';
import { parseMicroShader } from '../microshaders/parseMicroShader';

const sources = { ...coreSources, ...lists };

/** Names of the microshaders that techniques are made of. */
export type BuiltinMicroShader = keyof typeof sources;

/** The microshaders of opaque things, lights and light lists, whether their code is fetched or not. */
export const builtinMicroShaders: readonly MicroShader[] = Object.entries(sources).map(([name, text]) =>
  parseMicroShader(name, text),
);
