import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  Color,
  DoubleSide,
  Mesh,
  type MeshPhysicalMaterial,
  type Texture,
  Vector2,
  Vector3,
  type WebGLArrayRenderTarget,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { BakeMaterial } from '../gpu/BakeMaterial';
import type { MergedTriangles, TriangleRange } from '../scene/mergeTriangles';
import albedo from './albedo.frag.glsl?raw';
import place from './place.frag.glsl?raw';
import vertex from './surface.vert.glsl?raw';

/**
 * Offsets (texels) of repeated draws, the farthest first, so that a surface also covers texels that it touches without
 * reaching their centres.
 */
const SHIFTS = [1, 0.5].flatMap((d) =>
  [-1, 0, 1].flatMap((x) => [-1, 0, 1].filter((y) => x !== 0 || y !== 0).map((y) => [d * x, d * y] as const)),
);

/** Draws the meshes of a lightmap in lightmap UV space: one fragment per texel. */
export class Surfaces {
  private readonly geometry = new BufferGeometry();
  private readonly mesh: Mesh;
  private readonly camera = new Camera();
  private readonly shift = { value: new Vector2() };
  private readonly uniforms = {
    farol_shift: this.shift,
    farol_factor: { value: new Color() },
    farol_map: { value: null as Texture | null },
    farol_metalnessMap: { value: null as Texture | null },
    farol_metalness: { value: 0 },
    farol_uses: { value: [false, false, false] },
  };
  private readonly materials: Record<'place' | 'albedo' | 'emission', BakeMaterial>;

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly triangles: MergedTriangles,
    private readonly size: number,
  ) {
    const { positions, normals, lightmapUVs, mapUVs, emissiveUVs, colours, count } = triangles;
    const set = (name: string, array: Float32Array, each: number) =>
      this.geometry.setAttribute(name, new BufferAttribute(array, each));
    set('position', positions, 3);
    set('normal', normals, 3);
    set('face', faceNormals(positions, count), 3);
    set('lightmapUV', lightmapUVs, 2);
    set('mapUV', mapUVs, 2);
    set('emissiveUV', emissiveUVs, 2);
    if (colours) set('colour', colours, 3);
    this.mesh = new Mesh(this.geometry);
    this.mesh.frustumCulled = false;
    const material = (name: string, fragment: string, defines = {}) =>
      new BakeMaterial(name, vertex, fragment, this.uniforms, { side: DoubleSide, defines });
    this.materials = {
      place: material('place', place),
      albedo: material('albedo', albedo),
      emission: material('emission', albedo, { EMISSION: '' }),
    };
  }

  /** Draws positions, normals and face normals of the lightmap's texels to a target with three textures. */
  drawPlaces(lightmap: number, target: WebGLRenderTarget): void {
    this.draw('place', this.rangesOf(lightmap, true), target, 0);
  }

  drawAlbedo(lightmap: number, target: WebGLRenderTarget): void {
    this.draw('albedo', this.rangesOf(lightmap, false), target, 0, (range) => this.setAlbedo(range));
  }

  /** Draws the emissive colour of the lightmap's texels to a layer. */
  drawEmission(lightmap: number, target: WebGLArrayRenderTarget): void {
    this.draw('emission', this.rangesOf(lightmap, false), target, lightmap, (range) => this.setEmission(range));
  }

  dispose(): void {
    this.geometry.dispose();
    Object.values(this.materials).forEach((material) => material.dispose());
  }

  private rangesOf(lightmap: number, isMerged: boolean): TriangleRange[] {
    const ranges = this.triangles.ranges.filter((range) => range.lightmap === lightmap);
    if (!isMerged || ranges.length === 0) return ranges;
    return [{ ...ranges[0], count: ranges.reduce((sum, { count }) => sum + count, 0) }];
  }

  private draw(
    name: 'place' | 'albedo' | 'emission',
    ranges: readonly TriangleRange[],
    target: WebGLRenderTarget | WebGLArrayRenderTarget,
    layer: number,
    prepare?: (range: TriangleRange) => void,
  ): void {
    const material = (this.mesh.material = this.materials[name]);
    target.scissorTest = false;
    this.renderer.setRenderTarget(target, layer);
    this.renderer.clear();
    for (const [x, y] of [...SHIFTS, [0, 0]]) {
      this.shift.value.set(x, y).divideScalar(this.size);
      for (const range of ranges) {
        prepare?.(range);
        material.uniformsNeedUpdate = true;
        this.geometry.setDrawRange(3 * range.first, 3 * range.count);
        this.renderer.render(this.mesh, this.camera);
      }
    }
  }

  private setAlbedo({ material }: TriangleRange): void {
    const { color, map, metalness, metalnessMap, transmission } = material as MeshPhysicalMaterial;
    const { farol_factor, farol_map, farol_metalnessMap, farol_metalness, farol_uses } = this.uniforms;
    farol_factor.value.set(color ?? 0xffffff).multiplyScalar(1 - (transmission ?? 0));
    farol_map.value = map ?? null;
    farol_metalness.value = metalness ?? 0;
    farol_metalnessMap.value = metalnessMap ?? null;
    farol_uses.value = [Boolean(map), Boolean(metalnessMap), this.triangles.colours !== null];
  }

  private setEmission({ material }: TriangleRange): void {
    const { emissive, emissiveIntensity, emissiveMap } = material as MeshPhysicalMaterial;
    const { farol_factor, farol_map, farol_uses } = this.uniforms;
    farol_factor.value.set(emissive ?? 0x000000).multiplyScalar(emissiveIntensity ?? 1);
    farol_map.value = emissiveMap ?? null;
    farol_uses.value = [Boolean(emissiveMap), false, false];
  }
}

function faceNormals(positions: Float32Array, count: number): Float32Array {
  const normals = new Float32Array(positions.length);
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  for (let i = 0; i < count; i++) {
    [a, b, c].forEach((corner, k) => corner.fromArray(positions, 9 * i + 3 * k));
    b.sub(a).cross(c.sub(a)).normalize();
    for (let k = 0; k < 3; k++) b.toArray(normals, 9 * i + 3 * k);
  }
  return normals;
}
