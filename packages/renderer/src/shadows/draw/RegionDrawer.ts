import {
  type Mesh,
  OrthographicCamera,
  type RawShaderMaterial,
  type ShaderMaterial,
  Vector4,
  type WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import type { FullscreenPass, MeshDrawer } from '../../gpu/FullscreenPass';
import type { MicroShaderRegistry } from '../../microshaders';
import { directDraw, type DirectDraw } from '../../three/directDraw';
import { setViewport } from '../../three/state';

const camera = new OrthographicCamera(); // camera argument of three's draw; three changes its projection for reversed depth
const rectangle = new Vector4();

/** Draws full-screen passes to parts of targets, inside three's `render` but without a `Frame`. */
export class RegionDrawer implements MeshDrawer {
  readonly uniforms = {};
  private readonly draw: DirectDraw;

  constructor(
    private readonly webgl: WebGLRenderer,
    readonly microshaders: MicroShaderRegistry,
  ) {
    this.draw = directDraw(webgl);
  }

  bind(target: WebGLRenderTarget): void {
    this.webgl.setRenderTarget(target);
  }

  drawMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    this.draw(camera, null, mesh.geometry, material, mesh, null);
  }

  compileMesh(mesh: Mesh, material: RawShaderMaterial | ShaderMaterial): void {
    const { drawRange } = mesh.geometry;
    const { count } = drawRange;
    drawRange.count = 0;
    try {
      this.drawMesh(mesh, material);
    } finally {
      // restored, since meshes of other renderers share this geometry
      drawRange.count = count;
    }
  }

  /** Draws a pass to a part of the bound target (texels). */
  drawPart(pass: FullscreenPass, x: number, y: number, width: number, height: number): void {
    setViewport(this.webgl, rectangle.set(x, y, width, height));
    pass.draw(this);
  }
}
