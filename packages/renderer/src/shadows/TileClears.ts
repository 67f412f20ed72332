import {
  AlwaysDepth,
  Camera,
  DoubleSide,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  NoBlending,
  Vector4,
  type WebGLRenderer,
} from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import { PassMaterial } from '../passes/PassMaterial';
import { casterStand } from './casterStand';
import type { ShadowFace } from './ShadowFace';
import type { Draw } from './ShadowMapDraws';

const camera = new Camera();
const viewport = new Vector4();
/** Two triangles. */
const VERTICES = 6;

/** Clears what faces draw to in an atlas of depths, all in one draw: on a GPU that is quicker than a clear of each. */
export class TileClears {
  /** Stands in for the rectangles in three's traversal, so that they are sent. */
  readonly stand: Mesh;
  private readonly geometry = new InstancedBufferGeometry();
  private readonly mesh: Mesh;
  private readonly material: PassMaterial;
  private readonly far = { value: 1 };
  private rectangles = new InstancedBufferAttribute(new Float32Array(4 * 64), 4);
  private count = 0;

  constructor(
    private readonly webgl: WebGLRenderer,
    registry: MicroShaderRegistry,
  ) {
    this.geometry.setDrawRange(0, VERTICES);
    this.give(this.rectangles);
    this.material = new PassMaterial(registry, {
      name: 'Farol shadow map clears',
      vertex: ['tileClear'],
      fragment: ['mergedCasterDepth'],
      uniforms: { farol_far: this.far },
      blending: NoBlending,
      side: DoubleSide,
      depthTest: true,
      depthWrite: true,
      depthFunc: AlwaysDepth,
    });
    this.material.colorWrite = false;
    this.mesh = new Mesh(this.geometry, this.material);
    this.mesh.frustumCulled = false;
    this.stand = casterStand(this.mesh) as Mesh;
  }

  /** Begins a frame. */
  begin(): void {
    this.count = 0;
  }

  /** Has the part of a face that is drawn cleared. @param size of the atlas, texels a side */
  add({ x, y, drawn }: ShadowFace, size: number): void {
    if (drawn.left >= drawn.right || drawn.bottom >= drawn.top) return;
    if (this.count === this.rectangles.count) this.grow();
    const scale = 2 / size;
    this.rectangles.setXYZW(
      this.count++,
      (x + drawn.left) * scale - 1,
      (y + drawn.bottom) * scale - 1,
      (x + drawn.right) * scale - 1,
      (y + drawn.top) * scale - 1,
    );
    this.rectangles.needsUpdate = true;
  }

  /** Clears them in the bound target. @param size of it, texels a side */
  draw(size: number): void {
    if (this.count === 0) return;
    const { webgl, geometry, material, mesh } = this;
    webgl.state.viewport(viewport.set(0, 0, size, size));
    webgl.state.setScissorTest(false);
    this.far.value = webgl.state.buffers.depth.getReversed() ? 0 : 1;
    material.uniformsNeedUpdate = true;
    geometry.instanceCount = this.count;
    (webgl.renderBufferDirect as unknown as Draw)(camera, null, geometry, material, mesh, null);
  }

  dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }

  private grow(): void {
    const more = new InstancedBufferAttribute(new Float32Array(this.rectangles.array.length * 2), 4);
    more.array.set(this.rectangles.array);
    this.geometry.dispose();
    this.give(more);
  }

  private give(rectangles: InstancedBufferAttribute): void {
    this.rectangles = rectangles;
    rectangles.usage = DynamicDrawUsage;
    this.geometry.setAttribute('farol_rectangle', rectangles);
  }
}
