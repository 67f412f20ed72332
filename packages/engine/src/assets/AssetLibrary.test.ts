import { BoxGeometry, MeshBasicMaterial, ShaderMaterial, type DataTexture } from 'three';
import { describe, expect, test } from 'vitest';
import { textureSizes } from '../textures/builtinTextures';
import { AssetLibrary } from './AssetLibrary';

describe('names', () => {
  test('cannot be used twice, nor be empty', () => {
    const assets = new AssetLibrary();
    expect(() => assets.register('box', new BoxGeometry())).toThrow(/'box' is there already/);
    expect(() => assets.register('', new BoxGeometry())).toThrow(/needs a name/);
  });

  test('that are unknown, of another type or not readable are told', () => {
    const assets = new AssetLibrary();
    expect(() => assets.get('teapot')).toThrow(/The asset 'teapot' is unknown/);
    expect(() => assets.mesh('checker')).toThrow(/'checker' is a texture: a mesh is needed/);
    expect(() => assets.registerUrl('film', 'film.mp4')).toThrow(/'film' cannot be read from 'film\.mp4'/);
  });

  test('are listed by type', () => {
    const assets = new AssetLibrary();
    assets.register('red', new MeshBasicMaterial()).register('glow', new ShaderMaterial());
    expect(assets.list('material')).toEqual(['red']);
    expect(assets.list('shader')).toEqual(['glow']);
    expect(assets.list('mesh')).toEqual(expect.arrayContaining(['box', 'dragon']));
    expect(assets.list()).toHaveLength(new Set(assets.list()).size);
  });
});

describe('loading', () => {
  test('is done once, however many ask, and is told to listeners', async () => {
    let reads = 0;
    const ply =
      'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n';
    const assets = new AssetLibrary({
      urls: { shape: 'folder/shape.PLY?v=1' },
      fetchBytes: async () => {
        reads++;
        return new TextEncoder().encode(ply).buffer as ArrayBuffer;
      },
    });
    const told: string[] = [];
    assets.onChange(({ kind, name }) => told.push(`${kind} ${name}`));
    const [a, b] = await Promise.all([assets.load('shape'), assets.load('shape')]);
    expect(a).toBe(b);
    expect(reads).toBe(1);
    expect(told).toEqual(['loaded shape']);
    expect(await assets.load('shape')).toBe(a);
  });

  test('that fails is told by name, and may be tried again', async () => {
    let fail = true;
    const assets = new AssetLibrary({
      urls: { shape: 'shape.ply' },
      fetchBytes: async (url) => {
        if (fail) throw new Error(`${url} answered 404`);
        return new TextEncoder().encode('no ply').buffer as ArrayBuffer;
      },
    });
    await expect(assets.load('shape')).rejects.toThrow("The asset 'shape' could not be loaded: shape.ply answered 404");
    fail = false;
    await expect(assets.load('shape')).rejects.toThrow(/begins with "ply"/);
    await expect(assets.load('nobody')).rejects.toThrow(/'nobody' is unknown/);
  });
});

describe('generated textures', () => {
  const pixels = (name: string, size: number): Uint8Array => {
    const texture = new AssetLibrary().texture(`${name}${size === textureSizes[0] ? '' : `@${size}`}`) as DataTexture;
    expect(texture.image.width).toBe(size);
    return texture.image.data as Uint8Array;
  };

  test('are the same each time', () => {
    expect(pixels('brick', 128)).toEqual(pixels('brick', 128));
    expect(pixels('brick', 128)).not.toEqual(pixels('stone', 128));
  });

  test.each(['marble', 'stone', 'brick', 'tiles', 'plaster', 'wood', 'grass', 'cloth-red'])(
    '%s: neighbours across the border differ as little as inside, and normals point out',
    (name) => {
      const size = 128;
      const data = pixels(name, size);
      const step = (x0: number, x1: number): number => {
        let sum = 0;
        for (let y = 0; y < size; y++) sum += Math.abs(data[(y * size + x0) * 4 + 1] - data[(y * size + x1) * 4 + 1]);
        return sum / size;
      };
      const inside = Math.max(...Array.from({ length: size - 1 }, (_, x) => step(x, x + 1)));
      expect(step(size - 1, 0)).toBeLessThanOrEqual(inside + 1);
      const normals = pixels(`${name}-normal`, size);
      let bad = 0;
      for (let i = 0; i < normals.length; i += 4) {
        const [x, y, z] = [normals[i], normals[i + 1], normals[i + 2]].map((byte) => byte / 127.5 - 1);
        if (!(z > 0.2 && Math.abs(Math.hypot(x, y, z) - 1) < 0.02)) bad++;
      }
      expect(bad).toBe(0);
    },
  );
});

test('a name that is given to another asset forgets what was derived from the first', () => {
  const assets = new AssetLibrary();
  const [flat, tall] = [new BoxGeometry(1, 1, 1), new BoxGeometry(1, 9, 1)];
  for (const each of [flat, tall]) each.deleteAttribute('normal');
  assets.register('tower', flat);
  const before = assets.mesh('tower');
  assets.unregister('tower');
  assets.register('tower', tall);
  const after = assets.mesh('tower');
  after.computeBoundingBox();
  expect(after).not.toBe(before);
  expect(after.boundingBox!.max.y).toBe(4.5);
});
