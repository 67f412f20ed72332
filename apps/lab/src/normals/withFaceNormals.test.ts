import { AssetLibrary } from '@farol/engine';
import { BoxGeometry, type BufferGeometry, SphereGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import { countLeaning, withFaceNormals } from './withFaceNormals';
import { creaseAngle } from './NormalsPicture';

function bare(geometry: BufferGeometry): BufferGeometry {
  geometry.deleteAttribute('normal');
  return geometry;
}

describe('normals by faces', () => {
  it('are the mean of all faces of a place, by area: those of a box point out of its corners', () => {
    const source = bare(new BoxGeometry(2, 2, 2));
    const { position, normal } = withFaceNormals(source).attributes;
    expect(position.count).toBe(24);
    // a face has one triangle or two at a corner: the mean leans towards those that have two
    for (let i = 0; i < 24; i++) {
      const towards = [0, 1, 2].map((k) => normal.getComponent(i, k) * position.getComponent(i, k));
      expect(Math.min(...towards)).toBeGreaterThan(0.3);
      expect(Math.hypot(normal.getX(i), normal.getY(i), normal.getZ(i))).toBeCloseTo(1, 6);
    }
    expect(source.hasAttribute('normal')).toBe(false);
  });

  it('lean from the triangles at every corner of a box, and nowhere on a ball', () => {
    const box = countLeaning(withFaceNormals(bare(new BoxGeometry())), creaseAngle);
    expect(box).toEqual({ corners: 36, leaning: 36 });
    const ball = countLeaning(withFaceNormals(bare(new SphereGeometry(1, 48, 32))), creaseAngle);
    expect(ball.corners).toBeGreaterThan(8000);
    expect(ball.leaning).toBe(0);
  });

  it('are the same at both sides of a seam of texture coordinates', () => {
    const { position, normal } = withFaceNormals(bare(new SphereGeometry(1, 16, 12))).attributes;
    const row = 17;
    for (const [a, b] of [
      [row * 4, row * 4 + 16],
      [row * 7, row * 7 + 16],
    ]) {
      expect(position.getY(a)).toBeCloseTo(position.getY(b), 6);
      for (let k = 0; k < 3; k++) expect(normal.getComponent(a, k)).toBe(normal.getComponent(b, k));
    }
  });

  it('differ from those by crease angle, which lean nowhere', async () => {
    const assets = new AssetLibrary().register('bare', bare(new BoxGeometry()));
    const creased = await assets.prepareMesh('bare', creaseAngle);
    expect(countLeaning(creased, creaseAngle)).toEqual({ corners: 36, leaning: 0 });
    assets.dispose();
  });
});
