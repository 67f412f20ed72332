import {
  BufferGeometry,
  Camera,
  type IUniform,
  Mesh,
  type ShaderMaterialParameters,
  type WebGLArrayRenderTarget,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { BakeMaterial } from './BakeMaterial';

const VERTEX = `void main() {
  gl_Position = vec4(vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0), 0.0, 1.0);
}`;

/** Range of rows of a target to draw. */
export interface Rows {
  readonly first: number;
  readonly count: number;
}

/** A fragment shader over a whole target or a band of it. */
export class FullscreenPass {
  readonly material: BakeMaterial;
  private readonly mesh: Mesh<BufferGeometry, BakeMaterial>;
  private readonly camera = new Camera();

  constructor(
    name: string,
    fragment: string,
    readonly uniforms: Record<string, IUniform>,
    more: ShaderMaterialParameters = {},
  ) {
    this.material = new BakeMaterial(name, VERTEX, fragment, uniforms, more);
    const geometry = new BufferGeometry();
    geometry.setDrawRange(0, 3);
    this.mesh = new Mesh(geometry, this.material);
    this.mesh.frustumCulled = false;
  }

  /** @param layer - layer of an array target */
  draw(renderer: WebGLRenderer, target: WebGLRenderTarget | WebGLArrayRenderTarget, layer = 0, rows?: Rows): void {
    target.scissorTest = rows !== undefined;
    if (rows) target.scissor.set(0, rows.first, target.width, rows.count);
    renderer.setRenderTarget(target, layer);
    // three must send the uniforms again: their values may have changed since the last draw
    this.material.uniformsNeedUpdate = true;
    renderer.render(this.mesh, this.camera);
  }

  dispose(): void {
    this.material.dispose();
    this.mesh.geometry.dispose();
  }
}
