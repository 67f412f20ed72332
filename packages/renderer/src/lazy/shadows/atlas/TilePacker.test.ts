import { describe, expect, test } from 'vitest';
import { TilePacker, type Tile } from './TilePacker';

function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}

const overlap = (a: Tile, b: Tile) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

describe('TilePacker', () => {
  test('places never overlap and stay inside, whatever is placed and released', () => {
    const packer = new TilePacker(1024);
    const next = random(5);
    const placed: Tile[] = [];
    for (let i = 0; i < 2000; i++) {
      if (placed.length > 0 && next() < 0.45) {
        packer.release(placed.splice(Math.floor(next() * placed.length), 1)[0]);
        continue;
      }
      const tile = packer.place(1 + Math.floor(next() * 200), 1 + Math.floor(next() * 200));
      if (tile === null) continue;
      expect(tile.x >= 0 && tile.y >= 0 && tile.x + tile.width <= 1024 && tile.y + tile.height <= 1024).toBe(true);
      expect(placed.some((other) => overlap(tile, other))).toBe(false);
      placed.push(tile);
    }
    expect(placed.length).toBeGreaterThan(20);
  });

  test('a square of equal tiles is filled whole, and is whole again when all are released', () => {
    const packer = new TilePacker(256);
    const tiles: Tile[] = [];
    for (let i = 0; i < 64; i++) tiles.push(packer.place(32, 32)!);
    expect(tiles.every(Boolean)).toBe(true);
    expect(packer.place(1, 1)).toBeNull();
    for (const tile of tiles) packer.release(tile);
    expect(packer.place(256, 256)).toEqual({ x: 0, y: 0, width: 256, height: 256 });
  });
});
