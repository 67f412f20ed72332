import { builtinMicroShaders } from '../builtinMicroShaders';

const files = import.meta.glob<string>('../**/*.glsl', {
  // the query keeps the build from taking the comments out
  query: '?raw&commented',
  import: 'default',
  eager: true,
});
const written = new Map(Object.entries(files).map(([path, text]) => [nameOf(path), text]));

/**
 * The text of each built-in microshader as it was written, comments and all, by name; line for line that which is drawn with.
 * Those that are made from tables have no file: their text is that which is drawn with.
 */
export const microShaderSources: Readonly<Record<string, string>> = Object.fromEntries(
  builtinMicroShaders.map(({ name, header }) => [name, written.get(name) ?? header]),
);

function nameOf(path: string): string {
  return path.slice(path.lastIndexOf('/') + 1, -'.glsl'.length);
}
