import { gzipSync } from 'node:zlib';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { parsePly } from './parsePly';

const bytesOf = (text: string): ArrayBuffer => new TextEncoder().encode(text).buffer as ArrayBuffer;

/** A pyramid with a square base, as an ASCII PLY in gzip. */
const pyramid = new Uint8Array(
  gzipSync(`ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
element face 5
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 0 1
0 0 1
0.5 1 0.5
4 0 1 2 3
3 0 4 1
3 1 4 2
3 2 4 3
3 3 4 0
`),
).buffer as ArrayBuffer;

describe('a mesh in gzip', () => {
  test('has the triangles of its faces, and no normals but those of the file', async () => {
    const geometry = await parsePly(pyramid);
    expect(geometry.index!.count / 3).toBe(6);
    expect(geometry.getAttribute('position').count).toBe(5);
    expect(geometry.getAttribute('normal')).toBeUndefined();
  });

  test('is seen on the object that names it as soon as it is loaded, with normals by crease angle', async () => {
    const assets = new AssetLibrary({ urls: { pyramid: 'pyramid.ply.gz' }, fetchBytes: async () => pyramid });
    const scene = new Scene({ assets });
    const statue = new GameObject('Statue');
    scene.add(statue);
    const renderer = statue.addComponent(ObjectRenderer, { mesh: 'pyramid' });
    expect(renderer.three).toBeNull();
    expect(() => assets.get('pyramid')).toThrow(/'pyramid' is not loaded yet: await assets\.load\('pyramid'\)/);
    await assets.load('pyramid');
    await Promise.resolve();
    expect(renderer.three!.geometry.index!.count / 3).toBe(6);
    expect(assets.mesh('pyramid', Math.PI).getAttribute('position').count).toBe(5);
    expect(assets.mesh('pyramid', 0.3).getAttribute('position').count).toBe(16);
  });
});

describe('damaged data', () => {
  test.each([
    ['that are no PLY', bytesOf('solid teapot'), /begins with "ply"/],
    ['that are empty', new ArrayBuffer(0), /begins with "ply"/],
    ['of damaged gzip', new Uint8Array([0x1f, 0x8b, 1, 2, 3]).buffer as ArrayBuffer, /gzip data are damaged/],
    [
      'without faces',
      bytesOf(
        'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n',
      ),
      /no faces/,
    ],
  ])('%s are refused by name', async (_, data, message) => {
    await expect(parsePly(data)).rejects.toThrow(message);
  });
});
