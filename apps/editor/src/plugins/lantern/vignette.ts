import { type Frame, type Pass, type Technique, techniques } from '@farol/renderer';
import { BufferGeometry, GLSL3, Mesh, MultiplyBlending, RawShaderMaterial } from 'three';
import fragmentShader from './vignette.frag.glsl?raw';
import vertexShader from './vignette.vert.glsl?raw';

/** Darkens the picture towards its edges. */
class VignettePass implements Pass {
  readonly name = 'vignette';
  readonly reads = [] as const;
  readonly writes = ['target'] as const;
  readonly bytes = 0;
  private readonly material = new RawShaderMaterial({
    name: 'Vignette',
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: { size: { value: [1, 1] } },
    blending: MultiplyBlending,
    premultipliedAlpha: true,
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
  private readonly triangle = new Mesh(new BufferGeometry(), this.material);

  constructor() {
    this.triangle.geometry.setDrawRange(0, 3);
  }

  render(frame: Frame): void {
    if (frame.view !== 'final') return;
    frame.bindTarget();
    const size = this.material.uniforms.size.value as number[];
    size[0] = frame.width;
    size[1] = frame.height;
    this.material.uniformsNeedUpdate = true;
    frame.drawMesh(this.triangle, this.material);
  }

  dispose(): void {
    this.material.dispose();
    this.triangle.geometry.dispose();
  }
}

/** Tiled deferred shading, with one more pass of the plugin's own. */
export const vignette: Technique = {
  ...techniques['tiled-deferred'],
  label: 'Vignette',
  help: 'Tiled deferred shading that grows dark towards the edges: an example of a plugin.',
  passes: () => [...techniques['tiled-deferred'].passes(), new VignettePass()],
};
