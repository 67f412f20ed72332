import { type FarolEffect, FarolRenderer } from '@farol/renderer';
import {
  type Frame,
  FullscreenPass,
  gbufferUniforms,
  setGBufferUniforms,
  WebGLShaderCompiler,
} from '@farol/renderer/authoring';
import { readPixels } from '@farol/renderer/read-pixels';
import {
  Mesh,
  MeshStandardMaterial,
  PerspectiveCamera,
  PointLight,
  Scene,
  SphereGeometry,
  WebGLRenderer,
  WebGLRenderTarget,
} from 'three';

const showNormals = `#include "gbufferRead"
#include "viewport"
uniform vec2 farol_size;
layout(location = 0) out highp vec4 example_color;
//# main
ivec2 pixel = ivec2(gl_FragCoord.xy - farol_offset);
float depth = farol_gDepthAt(pixel);
if (farol_isEmptyPixel(pixel, depth)) discard;
example_color = vec4(farol_readSurface(pixel, depth, farol_size).normalVS * 0.5 + 0.5, 1.0);`;

/** Shows normals in view space, by techniques that have a G-buffer. */
class Normals implements FarolEffect {
  readonly name = 'normals';
  readonly bytes = 0;
  private readonly pass = new FullscreenPass({
    program: 'normals',
    fragment: 'showNormals',
    microShaders: { showNormals },
    shared: 'all',
    uniforms: gbufferUniforms(),
  });

  end(frame: Frame): void {
    const gbuffer = frame.resources.find('gbuffer');
    if (gbuffer === undefined) return;
    setGBufferUniforms(this.pass.uniforms, gbuffer, frame);
    frame.bindTarget();
    this.pass.draw(frame);
  }

  dispose(): void {
    this.pass.dispose();
  }
}

const webgl = new WebGLRenderer();
const farol = new FarolRenderer(webgl, { technique: 'deferred', effects: [new Normals()] });
const scene = new Scene();
scene.add(new Mesh(new SphereGeometry(), new MeshStandardMaterial()), new PointLight(0xffffff, 5, 20));
const camera = new PerspectiveCamera(50, 1, 0.1, 100);
camera.position.z = 2;
await farol.compileAsync(scene, camera);
const target = new WebGLRenderTarget(8, 8);
webgl.setRenderTarget(target);
farol.render(scene, camera);

const pixels = new Uint8Array(4);
await readPixels(webgl, target, 4, 4, 1, 1, pixels); // the middle one: it looks towards the camera
if (pixels[2] < 250) throw new Error(`The normal is shown as ${pixels.join(', ')}.`);

const compiler = new WebGLShaderCompiler(webgl.getContext() as WebGL2RenderingContext);
const program = compiler.compile({
  name: 'red',
  vertexShader: 'void main() { gl_Position = vec4(0.0); }',
  fragmentShader: 'void main() { gl_FragColor = vec4(1.0, 0.0, 0.0, 1.0); }',
});
webgl.getContext().deleteProgram(program);
