import type { Bake } from '@farol/bake';

/** Texels of a lightmap whose centre lies in a chart: one byte each, 1 where it does. */
export function coveredTexels({ meshes, lightmaps }: Bake, lightmap: number): Uint8Array {
  const { width, height } = lightmaps[lightmap];
  const covered = new Uint8Array(width * height);
  for (const mesh of meshes) if (mesh.lightmap === lightmap) cover(covered, width, height, mesh);
  return covered;
}

function cover(covered: Uint8Array, width: number, height: number, { uv1, index }: Bake['meshes'][number]): void {
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = [2 * index[i], 2 * index[i + 1], 2 * index[i + 2]];
    const [ax, ay, bx, by] = [uv1[a] * width, uv1[a + 1] * height, uv1[b] * width, uv1[b + 1] * height];
    const [cx, cy] = [uv1[c] * width, uv1[c + 1] * height];
    const sign = Math.sign((bx - ax) * (cy - ay) - (by - ay) * (cx - ax));
    if (sign === 0) continue;
    const [top, bottom] = [Math.floor(Math.min(ay, by, cy)), Math.min(height - 1, Math.max(ay, by, cy))];
    const [left, right] = [Math.floor(Math.min(ax, bx, cx)), Math.min(width - 1, Math.max(ax, bx, cx))];
    for (let y = top; y <= bottom; y++) {
      for (let x = left; x <= right; x++) {
        const [px, py] = [x + 0.5, y + 0.5];
        const isInside =
          sign * ((bx - ax) * (py - ay) - (by - ay) * (px - ax)) >= 0 &&
          sign * ((cx - bx) * (py - by) - (cy - by) * (px - bx)) >= 0 &&
          sign * ((ax - cx) * (py - cy) - (ay - cy) * (px - cx)) >= 0;
        if (isInside) covered[y * width + x] = 1;
      }
    }
  }
}
