import { type Charts, NO_CHART } from './cutCharts';

export interface Chart {
  /** Indices of the chart's vertices in `uvs`, each once. */
  readonly vertices: Uint32Array;
  /** Triangles of the chart, three vertex indices each. */
  readonly triangles: Uint32Array;
  /** Left bound of the chart's UVs (m). */
  readonly left: number;
  readonly bottom: number;
  readonly width: number;
  readonly height: number;
}

/** Splits a surface into its charts. Triangles without area are in none. */
export function chartsOf({ uvs, index, charts }: Charts): Chart[] {
  const triangles: number[][] = [];
  charts.forEach((chart, triangle) => {
    const [a, b, c] = index.subarray(3 * triangle, 3 * triangle + 3);
    if (chart !== NO_CHART) (triangles[chart] ??= []).push(a, b, c);
  });
  return triangles.filter(Boolean).map((each) => {
    const vertices = Uint32Array.from(new Set(each));
    let [left, bottom, right, top] = [Infinity, Infinity, -Infinity, -Infinity];
    for (const vertex of vertices) {
      left = Math.min(left, uvs[2 * vertex]);
      right = Math.max(right, uvs[2 * vertex]);
      bottom = Math.min(bottom, uvs[2 * vertex + 1]);
      top = Math.max(top, uvs[2 * vertex + 1]);
    }
    return { vertices, triangles: Uint32Array.from(each), left, bottom, width: right - left, height: top - bottom };
  });
}
