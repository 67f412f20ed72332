import { coreSources } from '../renderer/coreSources';
import * as lists from '../techniques/light-lists/chunks';
import type { MicroShader } from '../microshaders/MicroShader';
import { parseMicroShader } from '../microshaders/parseMicroShader';

const sources = { ...coreSources, ...lists };

/** Names of the built-in microshaders of techniques. */
export type BuiltinMicroShader = keyof typeof sources;

/** The built-in microshaders of opaque objects, lights and light lists, including those of late code. */
export const builtinMicroShaders: readonly MicroShader[] = Object.entries(sources).map(([name, text]) =>
  parseMicroShader(name, text),
);
