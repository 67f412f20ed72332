import { ShaderChunk } from 'three';
import { TwinRefusal } from './TwinRefusal';

type ChunkName = keyof typeof ShaderChunk;

/** Text of a chunk in a shader: its include, or three's text where the host has expanded the include; null for neither. */
export function findChunk(shader: string, name: ChunkName): string | null {
  const include = `#include <${name}>`;
  if (shader.includes(include)) return include;
  const text = ShaderChunk[name];
  return shader.includes(text) ? text : null;
}

/**
 * Replaces all occurrences of a chunk of three's in a shader.
 * @param by - returns the new text for the current one
 * @throws TwinRefusal if the shader has no such chunk, since the host has changed or left it out
 */
export function replaceChunk(shader: string, name: ChunkName, by: (found: string) => string): string {
  const found = findChunk(shader, name);
  if (found === null) throw new TwinRefusal(name);
  return shader.split(found).join(by(found));
}

/** Replaces a part of a text. @throws TwinRefusal if the text has no such part */
export function replacePart(text: string, part: string, by: string): string {
  if (!text.includes(part)) throw new TwinRefusal(part);
  return text.replace(part, () => by);
}

/** Inserts statements after a chunk of three's, or, in a shader without it, at the end of main(). */
export function afterChunkOrAtEnd(shader: string, name: ChunkName, statements: string): string {
  const found = findChunk(shader, name);
  if (found !== null) return shader.replace(found, () => `${found}\n${statements}`);
  const at = shader.lastIndexOf('}');
  return `${shader.slice(0, at)}\n${statements}\n${shader.slice(at)}`;
}
