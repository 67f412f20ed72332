import { type Chart, chartsOf } from './chartsOf';
import type { Charts } from './cutCharts';
import { type Footprint, footprintOf } from './footprint';
import { TexelGrid } from './TexelGrid';

/** A chart of a surface, at the scale that is being tried. */
interface Shape {
  readonly uvs: Float32Array;
  readonly chart: Chart;
  footprint: Footprint;
}

/** A chart of one mesh, and its position in the lightmap. */
interface Piece {
  readonly shape: Shape;
  place: number;
}

/**
 * Packs charts of meshes into one lightmap at a given density: tallest first, each at the first position where its
 * texels fit, so that small charts fill gaps between large ones.
 *
 * @see Lévy et al. 2002, Least Squares Conformal Maps for Automatic Texture Atlas Generation, section 5
 */
export class ChartPacker {
  private readonly shapes: Shape[] = [];
  private readonly pieces: Piece[][] = [];
  private scale = 0;

  /** @param surfaces - one per mesh; meshes with equal surfaces share one object */
  constructor(
    private readonly surfaces: readonly Charts[],
    private readonly size: number,
    private readonly padding: number,
  ) {
    const known = new Map<Charts, Shape[]>();
    for (const surface of surfaces) {
      let shapes = known.get(surface);
      if (!shapes) {
        const { uvs } = surface;
        shapes = chartsOf(surface).map((chart) => ({ uvs, chart, footprint: this.footprintOf(uvs, chart, 0) }));
        known.set(surface, shapes);
        this.shapes.push(...shapes);
      }
      this.pieces.push(shapes.map((shape) => ({ shape, place: -1 })));
    }
  }

  /**
   * Sets the charts' density.
   * @returns share of the lightmap that the charts need, with half of the padding around them
   */
  need(texelsPerMetre: number): number {
    if (this.scale !== texelsPerMetre) {
      this.scale = texelsPerMetre;
      for (const shape of this.shapes) shape.footprint = this.footprintOf(shape.uvs, shape.chart, texelsPerMetre);
    }
    const all = this.pieces.flat().reduce((sum, { shape }) => sum + shape.footprint.need, 0);
    return all / this.size ** 2;
  }

  /** Packs all charts at a density. @returns whether all fit */
  pack(texelsPerMetre: number): boolean {
    this.need(texelsPerMetre);
    const grid = new TexelGrid(this.size);
    // last position of a chart by its width and height: the search for an equal one begins there
    const last = new Map<number, number>();
    const order = this.pieces
      .flat()
      .sort(({ shape: { footprint: a } }, { shape: { footprint: b } }) => b.height - a.height || b.width - a.width);
    for (const piece of order) {
      const { footprint } = piece.shape;
      const sides = footprint.height * (this.size + 1) + footprint.width;
      piece.place = grid.find(footprint, last.get(sides) ?? 0);
      if (piece.place < 0) return false;
      last.set(sides, piece.place);
      grid.take(footprint, piece.place);
    }
    return true;
  }

  /** Lightmap UVs of a mesh's vertices, 0 to 1. */
  uv1Of(mesh: number): Float32Array {
    const { uvs } = this.surfaces[mesh];
    const uv1 = new Float32Array(uvs.length);
    for (const { shape, place } of this.pieces[mesh]) {
      const { chart, footprint } = shape;
      const column = place % (this.size + 1);
      const row = (place - column) / (this.size + 1);
      const { isTurned, scaleU, scaleV } = footprint;
      for (const vertex of chart.vertices) {
        const u = (uvs[2 * vertex] - chart.left) * scaleU;
        const v = (uvs[2 * vertex + 1] - chart.bottom) * scaleV;
        uv1[2 * vertex] = (column + 0.5 + (isTurned ? v : u)) / this.size;
        uv1[2 * vertex + 1] = (row + 0.5 + (isTurned ? u : v)) / this.size;
      }
    }
    return uv1;
  }

  private footprintOf(uvs: Float32Array, chart: Chart, texelsPerMetre: number): Footprint {
    return footprintOf(uvs, chart, texelsPerMetre, this.padding);
  }
}
