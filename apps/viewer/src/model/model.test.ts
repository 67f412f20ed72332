import { readGltfJson } from '@farol/engine/files';
import { describe, expect, it } from 'vitest';
import type { WebGLRenderer } from 'three';
import { findModel, lookUp, missingFiles, resolveUri } from './findModel';
import { loadModel } from './loadModel';

const files = (...paths: string[]) => new Map(paths.map((path) => [path, new File([path], path.split('/').pop()!)]));
const bytes = (text: string) => new TextEncoder().encode(text).buffer as ArrayBuffer;

/** A GLB of one JSON chunk. */
function glb(json: string, over: { version?: number; length?: number; cut?: number } = {}): ArrayBuffer {
  const body = new TextEncoder().encode(json);
  const buffer = new ArrayBuffer(20 + body.length);
  const view = new DataView(buffer);
  const words = [0x46546c67, over.version ?? 2, over.length ?? buffer.byteLength, body.length, 0x4e4f534a];
  words.forEach((word, index) => view.setUint32(index * 4, word, true));
  new Uint8Array(buffer, 20).set(body);
  return buffer.slice(0, over.cut ?? buffer.byteLength);
}

describe('readGltfJson', () => {
  const json = '{"asset":{"version":"2.0"},"extensionsUsed":["KHR_draco_mesh_compression"]}';

  it('reads the JSON of both kinds of file', () => {
    expect(readGltfJson(bytes(json)).extensionsUsed).toEqual(['KHR_draco_mesh_compression']);
    expect(readGltfJson(glb(json))).toEqual(readGltfJson(bytes(json)));
  });

  it.each([
    [bytes('hello'), /JSON cannot be read/],
    [bytes(''), /the file is empty: choose it again/],
    [bytes('[1]'), /not a glTF/],
    [bytes('{"asset":{"version":"1.0"}}'), /glTF 1\.0/],
    [glb(json, { cut: 16 }), /cut short \(16 bytes/],
    [glb(json, { cut: 60 }), /cut short \(its header says \d+ bytes, and it has 60/],
    [glb(json, { version: 1 }), /GLB version 1/],
    [glb('{'), /JSON cannot be read/],
    [glb(json, { length: 24, cut: 40 }), /first chunk/],
  ])('says what is wrong (%#)', (broken, message) => {
    expect(() => readGltfJson(broken)).toThrow(message);
  });
});

describe('the files of a model', () => {
  it('takes the model nearest to the top', () => {
    expect(findModel(files('room/old/a.gltf', 'room/b.glb', 'room/a.png'))).toBe('room/b.glb');
    expect(() => findModel(files('a.png', 'b.txt'))).toThrow(/a\.png, b\.txt/);
  });

  it('resolves a URI from the folder of the model', () => {
    expect(resolveUri('room/scene.gltf', './textures/../maps/a%20b.png')).toBe('room/maps/a b.png');
    expect(resolveUri('scene.gltf', 'data:image/png;base64,AA')).toBeNull();
  });

  it('finds files that lost their folder, and names those that are missing', () => {
    const dropped = files('scene.gltf', 'wall.png');
    expect(lookUp(dropped, 'textures/wall.png')?.name).toBe('wall.png');
    const json = { buffers: [{ uri: 'scene.bin' }, {}], images: [{ uri: 'textures/wall.png' }, { uri: 'data:,' }] };
    expect(missingFiles(dropped, 'scene.gltf', json)).toEqual(['scene.bin']);
  });
});

it('names the mend for a file that the browser cannot read', async () => {
  const huge = new File([], 'huge.glb');
  huge.arrayBuffer = async () => {
    throw new DOMException('typically due to permission problems', 'NotReadableError');
  };
  const message = loadModel(new Map([['huge.glb', huge]]), {} as WebGLRenderer);
  await expect(message).rejects.toThrow('huge.glb: the browser cannot read it: it has more than 2 GB');
});

it('tells little of files with long names, and of what a model names', async () => {
  const long = 'x'.repeat(100_000);
  const gltf = JSON.stringify({ asset: { version: '2.0' }, buffers: [{ uri: `${long}.bin`, byteLength: 4 }] });
  const cases: Record<string, string>[] = [
    { [`${long}.txt`]: 'a', [`${long}2.txt`]: 'b' },
    { [`${long}.glb`]: 'hello' },
    { [`${long}.zip`]: 'hello' },
    { 'a.gltf': gltf },
  ];
  for (const entries of cases) {
    const given = new Map(Object.entries(entries).map(([path, text]) => [path, new File([text], path)]));
    const message = await loadModel(given, {} as WebGLRenderer).catch((error: Error) => error.message);
    expect((message as string).length).toBeGreaterThan(20);
    expect((message as string).length).toBeLessThan(700);
  }
});
