import { describe, expect, it } from 'vitest';
import { LightGrid } from './LightGrid';
import {
  createRandom,
  orthographic,
  perspective,
  project,
  randomCones,
  randomDirection,
  randomSpheres,
  testCameras,
  type TestCamera,
} from './testing/testScenes';

const WIDTH = 320;
const HEIGHT = 184;
const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** farol_depthBin in JavaScript, with 32-bit floats. */
function binOf(grid: LightGrid, depth: number): number {
  float[0] = Math.max(0, Math.fround(Math.fround(depth) + Math.fround(grid.depthShift)));
  const bin = Math.fround(Math.fround(bits[0] - grid.depthStart) * Math.fround(grid.depthScale));
  return Math.min(1023, Math.max(0, Math.trunc(bin)));
}

function hasBit(grid: LightGrid, tileX: number, tileY: number, rank: number): boolean {
  const word = rank >> 5;
  const at = ((word >> 2) * grid.tilesY * grid.tilesX + tileY * grid.tilesX + tileX) * 4 + (word & 3);
  return ((grid.masks[at] >>> (rank & 31)) & 1) === 1;
}

/** The lights in the list of a tile and a depth's bin. */
function listAt(grid: LightGrid, tileX: number, tileY: number, depth: number): Set<number> {
  const bin = grid.bins[binOf(grid, depth)];
  const list = new Set<number>();
  for (let rank = 0; rank < grid.count; rank++) {
    const inRange = rank < grid.deepWords * 32 || (rank >= (bin & 0xffff) && rank <= bin >>> 16);
    if (inRange && hasBit(grid, tileX, tileY, rank)) list.add(grid.order[rank]);
  }
  return list;
}

interface Missing {
  point: number[];
  light: number[];
}

/** Random points in lights' ranges on screen, and the lights that reach a point but are not in its list. */
function missing(
  camera: TestCamera,
  grid: LightGrid,
  spheres: Float32Array,
  cones: Float32Array | null,
  samples: number,
) {
  const random = createRandom(99);
  const found: Missing[] = [];
  let checked = 0;
  const { projection, near, far } = camera;
  const count = spheres.length / 4;
  for (let i = 0; i < samples * 40 && checked < samples; i++) {
    const from = Math.floor(random() * count) * 4;
    const direction = randomDirection(random);
    const length = spheres[from + 3] * Math.min(1, 1.2 * random());
    const point = [0, 1, 2].map((k) => spheres[from + k] + direction[k] * length);
    const depth = -point[2];
    if (!(depth >= near && depth <= far)) continue;
    const [u, v] = project(projection, point[0], point[1], point[2]);
    if (!(Math.abs(u) < 1 && Math.abs(v) < 1)) continue;
    checked++;
    const tileX = Math.floor(((u * 0.5 + 0.5) * WIDTH) / grid.tileSize);
    const tileY = Math.floor(((v * 0.5 + 0.5) * HEIGHT) / grid.tileSize);
    const list = listAt(grid, tileX, tileY, depth);
    for (let light = 0; light < count; light++) {
      const at = light * 4;
      const x = point[0] - spheres[at];
      const y = point[1] - spheres[at + 1];
      const z = point[2] - spheres[at + 2];
      const distance = Math.sqrt(x * x + y * y + z * z);
      if (distance > spheres[at + 3]) continue;
      if (cones && cones[at + 3] > -1) {
        const along = -(x * cones[at] + y * cones[at + 1] + z * cones[at + 2]);
        if (along < distance * cones[at + 3]) continue;
      }
      if (!list.has(light)) found.push({ point, light: [...spheres.subarray(at, at + 4)] });
    }
  }
  return { found, checked };
}

function updated(
  camera: TestCamera,
  tileSize: number,
  spheres: Float32Array,
  cones: Float32Array | null = null,
  grid = new LightGrid(tileSize),
): LightGrid {
  grid.update(spheres.length / 4, spheres, camera.projection, camera.near, camera.far, WIDTH, HEIGHT, cones);
  return grid;
}

describe.each(testCameras)('the grid of lights, $name', (camera) => {
  const reach = Math.min(camera.far, 60);

  it.each([
    ['a few large lights', 40, 0.5, 32],
    ['many lights', 1500, 0.1, 16],
    ['tiles that do not divide the picture', 300, 0.2, 24],
  ])('misses no light at any point: %s', (_, count, radius, tileSize) => {
    const spheres = randomSpheres(count, createRandom(count), camera, reach, reach * radius);
    const grid = updated(camera, tileSize, spheres);
    const { found, checked } = missing(camera, grid, spheres, null, 150);
    expect(found.slice(0, 3)).toEqual([]);
    expect(checked).toBeGreaterThan(50);
  });

  it('misses no cone at any point', () => {
    const random = createRandom(3);
    const spheres = randomSpheres(500, random, camera, reach, reach * 0.2);
    const cones = randomCones(500, random);
    const grid = updated(camera, 16, spheres, cones);
    const { found, checked } = missing(camera, grid, spheres, cones, 150);
    expect(found.slice(0, 3)).toEqual([]);
    expect(checked).toBeGreaterThan(50);
  });

  it('marks every tile that a sphere reaches, and hardly another', () => {
    const spheres = randomSpheres(50, createRandom(8), camera, reach, reach * 0.1);
    const grid = updated(camera, 8, spheres);
    const { projection: m, near, far } = camera;
    const ranks = new Map(Array.from({ length: grid.count }, (_, rank) => [grid.order[rank], rank]));
    let marked = 0;
    let wrong = 0;
    for (let light = 0; light < 50; light++) {
      const [x, y, z, r] = spheres.subarray(light * 4, light * 4 + 4);
      if (r === 0) continue;
      const rank = ranks.get(light) ?? -1;
      for (let ty = 0; ty < grid.tilesY; ty++) {
        for (let tx = 0; tx < grid.tilesX; tx++) {
          let reached = false;
          for (let k = 0; k < 49 && !reached; k++) {
            const u = ((tx + (k % 7) / 6) * 8 * 2) / WIDTH - 1;
            const v = ((ty + Math.floor(k / 7) / 6) * 8 * 2) / HEIGHT - 1;
            reached = rayReaches(m, u, v, x, y, z, r, near, far);
          }
          const isMarked = rank >= 0 && hasBit(grid, tx, ty, rank);
          if (reached && !isMarked) expect.fail(`sphere ${[x, y, z, r].join()} reaches tile ${tx}, ${ty}`);
          if (isMarked) marked++;
          if (isMarked && !reached) wrong++;
        }
      }
    }
    expect(marked).toBeGreaterThan(100);
    // rows cut by the near or far plane are marked as if uncut, within the light's rectangle
    expect(wrong / marked).toBeLessThan(0.05);
  });

  it('sets no bit of a rank that is not used', () => {
    const spheres = randomSpheres(70, createRandom(4), camera, reach, reach * 0.2);
    const grid = updated(camera, 16, spheres);
    expect(grid.words % 4).toBe(0);
    let stray = 0;
    for (let ty = 0; ty < grid.tilesY; ty++) {
      for (let tx = 0; tx < grid.tilesX; tx++) {
        for (let rank = grid.count; rank < grid.words * 32; rank++) if (hasBit(grid, tx, ty, rank)) stray++;
      }
    }
    expect(stray).toBe(0);
  });
});

/** Whether the ray through a point of the screen hits a sphere between near and far plane. */
function rayReaches(
  m: readonly number[],
  u: number,
  v: number,
  x: number,
  y: number,
  z: number,
  r: number,
  near: number,
  far: number,
): boolean {
  const perspectiveRay = m[11] !== 0;
  const dx = perspectiveRay ? (u + m[8]) / m[0] : 0;
  const dy = perspectiveRay ? (v + m[9]) / m[5] : 0;
  const ox = perspectiveRay ? 0 : (u - m[12]) / m[0];
  const oy = perspectiveRay ? 0 : (v - m[13]) / m[5];
  const squared = dx * dx + dy * dy + 1;
  const closest = ((x - ox) * dx + (y - oy) * dy - z) / squared;
  const t = Math.min(far, Math.max(near, closest));
  const [px, py, pz] = [ox + dx * t - x, oy + dy * t - y, -t - z];
  return px * px + py * py + pz * pz <= r * r;
}

describe('LightGrid', () => {
  const camera = testCameras[0];

  it('takes 10,000 lights', () => {
    const spheres = randomSpheres(10_000, createRandom(1), camera, 60, 1);
    const grid = updated(camera, 16, spheres);
    const { found, checked } = missing(camera, grid, spheres, null, 100);
    expect(found.slice(0, 3)).toEqual([]);
    expect(checked).toBe(100);
    const listed = listAt(grid, 5, 5, 30).size;
    expect(listed).toBeLessThan(100);
  });

  it.each([
    ['perspective', perspective(-1, 1, -1, 1, 0.1, 100), 0.1, 1, 90],
    ['orthographic', orthographic(-50, 50, -50, 50, 0.1, 100), 0.1, 1, 90],
    ['orthographic, all behind the camera', orthographic(-50, 50, -50, 50, -40, 60), -40, -39, 8],
  ])('orders lights by depth: %s', (_, projection, near, first, range) => {
    const random = createRandom(6);
    const spheres = new Float32Array(400 * 4);
    for (let i = 0; i < 400; i++) spheres.set([0, 0, -(first + range * random()), 0.01], i * 4);
    const grid = new LightGrid(32);
    grid.update(400, spheres, projection, near, near + 100, WIDTH, HEIGHT);
    expect([grid.count, grid.deepWords]).toEqual([400, 0]);
    expect(new Set(grid.order.subarray(0, 400)).size).toBe(400);
    for (let rank = 1; rank < 400; rank++) {
      const before = -spheres[grid.order[rank - 1] * 4 + 2];
      const depth = -spheres[grid.order[rank] * 4 + 2];
      // up to a bucket of the sort, a 4,080th of the range
      expect(depth).toBeGreaterThan(before - 0.005 * range);
    }
    const listed = spheres.filter((_, i) => i % 4 === 2).map((z) => listAt(grid, 5, 2, -z).size);
    expect(Math.min(...listed)).toBeGreaterThan(0);
    expect(Math.max(...listed)).toBeLessThan(20);
  });

  it('puts a few lights that reach far over the others before the bins, and so keeps these short', () => {
    const spheres = randomSpheres(4000, createRandom(2), camera, 60, 0.5);
    const small = updated(camera, 16, spheres);
    expect(small.deepWords).toBe(0);
    for (let i = 0; i < 20; i++) spheres[i * 4 + 3] = 30;
    const mixed = updated(camera, 16, spheres);
    expect(mixed.deepWords).toBeGreaterThan(0);
    const length = (grid: LightGrid) =>
      grid.bins.reduce((sum, bin) => sum + Math.max(0, (bin >>> 16) - (bin & 0xffff)), 0);
    expect(length(mixed)).toBeLessThan(1.2 * length(small));
    expect(missing(camera, mixed, spheres, null, 200).found.slice(0, 3)).toEqual([]);
  });

  it('never takes more than 128 lights for such', () => {
    const spheres = randomSpheres(4000, createRandom(2), camera, 60, 0.2);
    for (let i = 0; i < 400; i++) spheres[i * 4 + 3] = 20 + (i % 17);
    const grid = updated(camera, 16, spheres);
    expect(grid.deepWords).toBeLessThanOrEqual(4);
    expect(missing(camera, grid, spheres, null, 200).found.slice(0, 3)).toEqual([]);
  });

  it('leaves nothing of a frame in the next, and allocates only to grow', () => {
    const grid = new LightGrid(16);
    const many = randomSpheres(3000, createRandom(1), camera, 60, 3);
    const few = randomSpheres(40, createRandom(2), camera, 60, 3);
    updated(camera, 16, many, null, grid);
    const { masks, order, bins } = grid;
    for (const spheres of [few, new Float32Array(0), many]) {
      updated(camera, 16, spheres, null, grid);
      expect([grid.masks, grid.order, grid.bins].every((array, i) => array === [masks, order, bins][i])).toBe(true);
      const fresh = updated(camera, 16, spheres);
      const size = fresh.tilesX * fresh.tilesY * fresh.words;
      expect([grid.count, grid.words, grid.deepWords]).toEqual([fresh.count, fresh.words, fresh.deepWords]);
      expect(grid.masks.subarray(0, size).every((word, i) => word === fresh.masks[i])).toBe(true);
      expect(grid.order.subarray(0, grid.count).every((light, i) => light === fresh.order[i])).toBe(true);
      expect(grid.bins.every((bin, i) => bin === fresh.bins[i])).toBe(true);
    }
  });

  it('has no list where there are no lights, and keeps finite numbers', () => {
    const grid = updated(camera, 16, new Float32Array([0, 0, 50, 1]));
    expect([grid.count, grid.words]).toEqual([0, 0]);
    expect(grid.bins.every((bin) => (bin & 0xffff) > bin >>> 16)).toBe(true);
    expect([grid.depthShift, grid.depthStart, grid.depthScale].every(Number.isFinite)).toBe(true);
  });

  it('takes a light without end, and one far beyond the others', () => {
    const spheres = randomSpheres(200, createRandom(5), camera, 60, 2);
    spheres.set([0, 0, -2, Infinity], 0);
    spheres.set([0, 0, -9e7, 100], 4);
    for (const each of testCameras) {
      const grid = updated(each, 32, spheres);
      for (const depth of [each.near, 2, Math.min(each.far, 1e12)])
        expect(listAt(grid, 3, 2, depth).has(0), each.name).toBe(true);
    }
    const grid = updated(testCameras[4], 32, spheres);
    expect(listAt(grid, 5, 2, 9e7)).toContain(1);
    expect(listAt(grid, 5, 2, 9e7).size).toBeLessThan(20);
  });

  it('refuses more lights than ranks, and tiles of no size', () => {
    expect(() => new LightGrid(16).update(65_505, [], camera.projection, 0.1, 100, WIDTH, HEIGHT)).toThrow(
      /65505 lights; give 65504 at most/,
    );
    expect(() => new LightGrid(0)).toThrow(/tileSize is 0/);
  });
});
