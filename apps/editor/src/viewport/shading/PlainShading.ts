import {
  type Camera,
  Color,
  DoubleSide,
  MeshBasicMaterial,
  type Scene,
  ShaderMaterial,
  UniformsLib,
  UniformsUtils,
  type WebGLRenderer,
} from 'three';
import type { PlainShadingName } from './Shading';
import { UnlitMaterial } from './UnlitMaterial';
import fragmentShader from './clay.frag.glsl?raw';
import vertexShader from './clay.vert.glsl?raw';

/** Background colour, independent of the scene's, so that dark scenes are visible. */
const BACKGROUND = new Color(0x2a2d33);

/**
 * Renders a scene without its lights, shadows and effects, with three's renderer; the cost is independent of the number
 * of lights.
 */
export class PlainShading {
  private readonly wireframe = new MeshBasicMaterial({
    color: 0x989fab,
    wireframe: true,
    fog: false,
    toneMapped: false,
  });
  private readonly clay = new ShaderMaterial({
    name: 'Editor clay',
    vertexShader,
    fragmentShader,
    uniforms: UniformsUtils.clone(UniformsLib.common),
    side: DoubleSide,
    toneMapped: false,
  });

  private readonly unlit = new UnlitMaterial();

  constructor(private readonly webgl: WebGLRenderer) {}

  /** Renders to the current render target, viewport and scissor. */
  render(scene: Scene, camera: Camera, shading: PlainShadingName): void {
    const { webgl } = this;
    const { background, overrideMaterial, environment } = scene;
    const { autoUpdate } = webgl.shadowMap;
    scene.overrideMaterial = this[shading];
    if (shading !== 'unlit') scene.background = BACKGROUND;
    scene.environment = null;
    webgl.shadowMap.autoUpdate = false;
    try {
      webgl.render(scene, camera);
    } finally {
      scene.overrideMaterial = overrideMaterial;
      scene.background = background;
      scene.environment = environment;
      webgl.shadowMap.autoUpdate = autoUpdate;
    }
  }

  dispose(): void {
    this.wireframe.dispose();
    this.clay.dispose();
    this.unlit.dispose();
  }
}
