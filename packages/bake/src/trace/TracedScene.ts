import { Box3, type DataTexture, type Material, type MeshStandardMaterial, Vector3, type WebGLRenderer } from 'three';
import { measurePhase } from '../measurePhase';
import type { MergedTriangles } from '../scene/mergeTriangles';
import { dataTexture } from './dataTexture';
import { OpacityMasks } from './OpacityMasks';
import { packBvh } from './packBvh';

/** Triangles of a scene on the GPU, in the layout that traverse.glsl and emitters.glsl read. */
export class TracedScene {
  readonly bounds = new Box3();
  /** Offset of a ray's start from its surface (m). */
  readonly offset: number;
  readonly uniforms: Record<string, { value: unknown }>;
  readonly defines: Record<string, unknown>;
  /** Whether any triangle is emissive. */
  readonly shines: boolean;
  private readonly textures: Record<string, DataTexture>;
  private readonly masks: OpacityMasks;

  constructor(renderer: WebGLRenderer, triangles: MergedTriangles) {
    this.bounds.setFromArray(triangles.positions);
    const size = this.bounds.getSize(new Vector3()).length();
    this.offset = Math.min(Math.max(2e-5 * size, 1e-6), 2e-3);
    this.masks = new OpacityMasks(renderer, new Set(triangles.ranges.map(({ material }) => material)));
    let begin = performance.now();
    const bvh = packBvh(triangles.positions);
    measurePhase('bvh', begin);
    begin = performance.now();
    const rangeOf = new Int32Array(triangles.count);
    triangles.ranges.forEach(({ first, count }, range) => rangeOf.fill(range, first, first + count));
    const emitters = emittersOf(triangles, bvh.order, rangeOf);
    this.shines = emitters.power > 0;
    this.textures = {
      farol_nodes: dataTexture(bvh.nodes),
      farol_triangles: dataTexture(trianglesTable(triangles, bvh.order, rangeOf)),
      farol_corners: dataTexture(cornersTable(triangles, bvh.order)),
      farol_ranges: dataTexture(this.rangesTable(triangles)),
      farol_emitters: dataTexture(emitters.table),
    };
    this.uniforms = {
      ...Object.fromEntries(Object.entries(this.textures).map(([name, value]) => [name, { value }])),
      farol_opacity: { value: this.masks.target.texture },
      farol_emitterCount: { value: emitters.table.length / 4 },
      farol_emitterPower: { value: emitters.power },
      farol_offset: { value: this.offset },
    };
    this.defines = { BVH_DEPTH: bvh.depth };
    measurePhase('tables', begin);
  }

  dispose(): void {
    Object.values(this.textures).forEach((texture) => texture.dispose());
    this.masks.dispose();
  }

  /** Table of materials, eight numbers each: lightmap, mask, alpha test, opacity; double sided, shadowless, emission, unused. */
  private rangesTable({ ranges }: MergedTriangles): Float32Array {
    return Float32Array.from(
      ranges.flatMap(({ lightmap, material, isDoubleSided, throwsShadow }) => {
        const { layer, test, opacity } = this.masks.of(material);
        const luminance = lightmap < 0 ? 0 : emittedLuminance(material);
        return [lightmap, layer, test, opacity, Number(isDoubleSided), Number(!throwsShadow), luminance, 0];
      }),
    );
  }
}

/** Luminance of the radiance that a material emits, without its map. */
export function emittedLuminance(material: Material): number {
  const { emissive, emissiveIntensity } = material as MeshStandardMaterial;
  if (!emissive) return 0;
  return (0.2126 * emissive.r + 0.7152 * emissive.g + 0.0722 * emissive.b) * (emissiveIntensity ?? 1);
}

function trianglesTable({ positions }: MergedTriangles, order: Uint32Array, rangeOf: Int32Array): Float32Array {
  const table = new Float32Array(12 * order.length);
  order.forEach((triangle, i) => {
    const from = 9 * triangle;
    const to = 12 * i;
    for (let k = 0; k < 3; k++) {
      table[to + k] = positions[from + k];
      table[to + 4 + k] = positions[from + 3 + k] - positions[from + k];
      table[to + 8 + k] = positions[from + 6 + k] - positions[from + k];
    }
    table[to + 3] = rangeOf[triangle];
    table[to + 7] = triangle;
  });
  return table;
}

function cornersTable({ lightmapUVs, mapUVs }: MergedTriangles, order: Uint32Array): Float32Array {
  const table = new Float32Array(12 * order.length);
  order.forEach((triangle, i) => {
    for (let corner = 0; corner < 3; corner++) {
      const from = 6 * triangle + 2 * corner;
      const to = 12 * i + 4 * corner;
      table[to] = lightmapUVs[from];
      table[to + 1] = lightmapUVs[from + 1];
      table[to + 2] = mapUVs[from];
      table[to + 3] = mapUVs[from + 1];
    }
  });
  return table;
}

/** Emissive triangles, by their indices in the table, each with the cumulated share of all emitted power. */
function emittersOf({ ranges, positions }: MergedTriangles, order: Uint32Array, rangeOf: Int32Array) {
  const luminances = ranges.map(({ material, lightmap }) => (lightmap < 0 ? 0 : emittedLuminance(material)));
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const found: { place: number; until: number }[] = [];
  let power = 0;
  order.forEach((triangle, place) => {
    const luminance = luminances[rangeOf[triangle]];
    if (luminance === 0) return;
    [a, b, c].forEach((corner, k) => corner.fromArray(positions, 9 * triangle + 3 * k));
    power += 0.5 * luminance * b.sub(a).cross(c.sub(a)).length();
    found.push({ place, until: power });
  });
  const table = Float32Array.from(found.flatMap(({ place, until }) => [until / power, place, 0, 0]));
  return { table, power };
}
