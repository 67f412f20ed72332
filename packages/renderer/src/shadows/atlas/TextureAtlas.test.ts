import { WebGLRenderTarget } from 'three';
import { describe, expect, test } from 'vitest';
import { AtlasMap } from './AtlasMap';
import { AtlasPlacement } from './AtlasPlacement';
import { MapDetail } from './MapDetail';
import { type AtlasTenant, TextureAtlas } from './TextureAtlas';

class Tenant implements AtlasTenant {
  readonly placement = new AtlasPlacement();
  readonly map = new AtlasMap();
  readonly detail = new MapDetail();
  times = 0;
  border = 1;

  constructor(
    readonly wantedWidth: number,
    readonly isCube = false,
    public coverage = 1,
  ) {}

  get wantedHeight(): number {
    return this.wantedWidth;
  }

  get faceWidth(): number {
    return this.placement.faceWidth;
  }

  borderOf(): number {
    return this.isCube ? this.border : 0;
  }

  placed(): void {
    this.times++;
  }
}

const atlasOf = (limit: number) =>
  new TextureAtlas(
    limit,
    () => 5,
    (size) => new WebGLRenderTarget(size, size),
  );

function expectApart(tenants: readonly Tenant[], size: number): void {
  const regions = tenants.map(({ placement }) => placement.region!);
  regions.forEach((a, i) => {
    expect(a.x >= 0 && a.y >= 0 && a.x + a.width <= size && a.y + a.height <= size).toBe(true);
    for (const b of regions.slice(i + 1)) {
      const apart = a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
      expect(apart).toBe(true);
    }
  });
}

describe('TextureAtlas', () => {
  test('all have the size that they ask for while there is room; the atlas grows to what is needed', () => {
    const atlas = atlasOf(4096);
    const tenants = Array.from({ length: 20 }, (_, i) => new Tenant(128 + 64 * (i % 3), i % 4 === 0));
    atlas.arrange(tenants, [], true);
    for (const tenant of tenants) {
      expect([tenant.faceWidth, tenant.placement.faceHeight]).toEqual([tenant.wantedWidth, tenant.wantedWidth]);
      const border = tenant.isCube ? 2 * tenant.border : 0;
      expect(tenant.placement.region!.width).toBe((tenant.wantedWidth + border) * (tenant.isCube ? 3 : 1));
    }
    expectApart(tenants, atlas.target!.width);
    expect(atlas.target!.width).toBeLessThanOrEqual(2048);
  });

  test('a cube whose border changes is placed anew, once, with room for it', () => {
    const atlas = atlasOf(2048);
    const tenants = [new Tenant(128, true), new Tenant(128, true), new Tenant(100)];
    atlas.arrange(tenants, [], true);
    tenants[0].border = 4;
    atlas.arrange(tenants, [], true);
    const placed = tenants.map((tenant) => tenant.times);
    expect(placed[0]).toBeGreaterThan(1);
    atlas.arrange(tenants, [], true);
    expect(tenants.map((tenant) => tenant.times)).toEqual(placed);
    expect(tenants[0].placement.region).toMatchObject({ width: 3 * 136, height: 2 * 136 });
    expectApart(tenants, atlas.target!.width);
  });

  test('nothing moves while nothing changes, and one that comes or goes leaves the others where they are', () => {
    const atlas = atlasOf(2048);
    const tenants = Array.from({ length: 8 }, () => new Tenant(256));
    atlas.arrange(tenants, [], true);
    const before = tenants.map(({ placement, times }) => ({ region: placement.region, times }));
    atlas.arrange(tenants, [], true);
    atlas.release(tenants[3]);
    const others = tenants.filter((_, i) => i !== 3);
    atlas.arrange(others, [], true);
    atlas.arrange([...others, new Tenant(256)], [], true);
    others.forEach(({ placement, times }) => expect(before).toContainEqual({ region: placement.region, times }));
  });

  test('a full atlas halves those that cover least, gives all a place, and gives sizes back when others go', () => {
    const atlas = atlasOf(1024);
    const tenants = Array.from({ length: 24 }, (_, i) => new Tenant(512, i % 3 === 0, 1 / (1 + i)));
    atlas.arrange(tenants, [], true);
    expectApart(tenants, 1024);
    expect(tenants[1].faceWidth).toBeGreaterThan(tenants[23].faceWidth);
    const placed = tenants.map((tenant) => tenant.times);
    atlas.arrange(tenants, [], true);
    expect(tenants.map((tenant) => tenant.times)).toEqual(placed);
    for (const tenant of tenants.slice(2)) atlas.release(tenant);
    atlas.arrange([tenants[1]], [], true);
    expect(tenants[1].faceWidth).toBe(512);
  });

  test('maps are as small as pictures allow; what may be smaller waits for the look at all when the atlas is full', () => {
    const atlas = atlasOf(1024);
    const tenants = Array.from({ length: 4 }, () => new Tenant(512));
    tenants[0].detail.start(2);
    atlas.arrange(tenants, [], false);
    for (let i = 0; i < 40; i++) tenants[1].detail.aim(10, true);
    expect([tenants[1].detail.level, tenants[1].detail.target]).toEqual([0, 1]);
    atlas.arrange(tenants, [], true);
    expect(tenants.map(({ faceWidth }) => faceWidth)).toEqual([128, 512, 512, 512]);
    const more = [...tenants, new Tenant(512)];
    atlas.arrange(more, [], false);
    expect(more.map(({ faceWidth }) => faceWidth)).toEqual([128, 256, 512, 512, 512]);
    expectApart(more, 1024);
  });

  test('a large atlas grows by less than its size', () => {
    const atlas = atlasOf(8192);
    atlas.arrange(
      Array.from({ length: 5 }, () => new Tenant(2048)),
      [],
      true,
    );
    expect(atlas.target!.width).toBe(6144);
  });

  test('as a camera flies through many lights and the atlas is full, few maps are drawn anew at a look', () => {
    const atlas = atlasOf(2048);
    const tenants = Array.from({ length: 40 }, (_, i) => new Tenant(i % 3 ? 256 : 160, i % 2 === 0));
    const fly = (look: number) => {
      tenants.forEach((tenant, i) => (tenant.coverage = 1 / (1 + Math.abs(i - look))));
      const before = tenants.map(({ times }) => times);
      atlas.arrange(tenants, [], true);
      return tenants.filter(({ times }, i) => times !== before[i]).length;
    };
    expect(fly(0)).toBe(40);
    const anew = Array.from({ length: 38 }, (_, look) => fly(look + 1));
    expectApart(tenants, 2048);
    // few maps move: one out of the atlas, one into it, and some whose region was too small; all only rarely, if free room is in
    // pieces
    expect(anew.filter((count) => count > 12).length).toBeLessThanOrEqual(2);
    // those near the camera have their wanted size, or half of it
    for (const tenant of tenants.slice(36)) expect(tenant.faceWidth).toBeGreaterThanOrEqual(128);
    const texels = tenants.reduce((sum, { placement: { region } }) => sum + region!.width * region!.height, 0);
    expect(texels).toBeGreaterThan(0.6 * 2048 * 2048);
  });

  test('a larger limit lets halved maps have what they ask for, at the next look; a smaller one changes nothing', () => {
    const atlas = atlasOf(0);
    atlas.raiseLimit(1024);
    const tenants = Array.from({ length: 9 }, () => new Tenant(512));
    atlas.arrange(tenants, [], true);
    expect(tenants.filter(({ faceWidth }) => faceWidth < 512).length).toBeGreaterThan(0);
    expect(atlas.target!.width).toBe(1024);
    atlas.raiseLimit(2048);
    atlas.arrange(tenants, [], true);
    expect(tenants.every(({ faceWidth }) => faceWidth === 512)).toBe(true);
    const placed = tenants.map((tenant) => tenant.times);
    atlas.raiseLimit(256);
    atlas.arrange(tenants, [], true);
    expect(tenants.map((tenant) => tenant.times)).toEqual(placed);
    expectApart(tenants, 2048);
  });

  test('regions that are only kept make room', () => {
    const atlas = atlasOf(512);
    const kept = Array.from({ length: 4 }, () => new Tenant(256));
    atlas.arrange(kept, [], true);
    const fresh = [new Tenant(512)];
    atlas.arrange(fresh, kept, true);
    expect(fresh[0].faceWidth).toBe(512);
    expect(fresh[0].placement.region).not.toBeNull();
    expect(kept.every(({ placement, map }) => placement.region === null && map.state === 'none')).toBe(true);
  });
});
