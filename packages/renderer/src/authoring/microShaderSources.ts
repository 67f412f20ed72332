import { builtinMicroShaders } from './builtinMicroShaders';

const files = import.meta.glob<string>('../**/*.glsl', {
  // the query keeps the build from taking the comments out
  query: '?raw&commented',
  import: 'default',
  eager: true,
});
const builtin = new Set(builtinMicroShaders.map(({ name }) => name));
const nameOf = (path: string): string => path.slice(path.lastIndexOf('/') + 1, -'.glsl'.length);

/** The text of each built-in microshader as it was written, comments and all, by name; line for line that which is drawn with. */
export const microShaderSources: Readonly<Record<string, string>> = Object.fromEntries(
  Object.entries(files)
    .map(([path, text]) => [nameOf(path), text] as const)
    .filter(([name]) => builtin.has(name)),
);
