import { describe, expect, test } from 'vitest';
import type { Region } from './AtlasPlacement';
import { RegionPacker } from './RegionPacker';

function random(seed: number): () => number {
  return () => {
    seed = (seed * 16807) % 2147483647;
    return (seed - 1) / 2147483646;
  };
}

const overlap = (a: Region, b: Region) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

describe('RegionPacker', () => {
  test('places never overlap and stay inside, whatever is placed and released', () => {
    const packer = new RegionPacker(1024);
    const next = random(5);
    const placed: Region[] = [];
    for (let i = 0; i < 2000; i++) {
      if (placed.length > 0 && next() < 0.45) {
        packer.release(placed.splice(Math.floor(next() * placed.length), 1)[0]);
        continue;
      }
      const region = packer.place(1 + Math.floor(next() * 200), 1 + Math.floor(next() * 200));
      if (region === null) continue;
      expect(
        region.x >= 0 && region.y >= 0 && region.x + region.width <= 1024 && region.y + region.height <= 1024,
      ).toBe(true);
      expect(placed.some((other) => overlap(region, other))).toBe(false);
      placed.push(region);
    }
    expect(placed.length).toBeGreaterThan(20);
  });

  test('a square of equal regions is filled whole, and is whole again when all are released', () => {
    const packer = new RegionPacker(256);
    const regions: Region[] = [];
    for (let i = 0; i < 64; i++) regions.push(packer.place(32, 32)!);
    expect(regions.every(Boolean)).toBe(true);
    expect(packer.place(1, 1)).toBeNull();
    for (const region of regions) packer.release(region);
    expect(packer.place(256, 256)).toEqual({ x: 0, y: 0, width: 256, height: 256 });
  });
});
