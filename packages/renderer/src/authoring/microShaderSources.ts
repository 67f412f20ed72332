import { builtinMicroShaders } from './builtinMicroShaders';

const files = import.meta.glob<string>('../**/*.glsl', {
  // the query keeps the build from removing comments
  query: '?raw&commented',
  import: 'default',
  eager: true,
});
const builtin = new Set(builtinMicroShaders.map(({ name }) => name));
const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1, -'.glsl'.length);

/** Text of each built-in microshader as written, with comments, by name; its line numbers equal those of the compiled text. */
export const microShaderSources: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(files)
    .map(([path, text]) => [nameOf(path), text] as const)
    .filter(([name]) => builtin.has(name)),
);
