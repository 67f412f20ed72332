import { followEffects, type Scene } from '@farol/engine';
import { FarolRenderer } from '@farol/renderer';
import { readPixels } from '@farol/renderer/read-pixels';
import {
  type Camera,
  Color,
  DataUtils,
  GLSL3,
  HalfFloatType,
  Mesh,
  MeshPhysicalMaterial,
  OrthographicCamera,
  PlaneGeometry,
  RawShaderMaterial,
  Scene as ThreeScene,
  SRGBColorSpace,
  Vector2,
  Vector3,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { whenLost } from '../whenLost';
import vertexShader from '../painters/whole.vert.glsl?raw';
import fragmentShader from './falseColours.frag.glsl?raw';
import { illuminanceStops } from './scale';

const black = new Color(0);
const size = new Vector2();

/**
 * Illuminance of the visible surfaces (lx): the scene drawn in matt white under all its lights, shadows, profiles and
 * its environment. A white surface of luminance L (cd/m²) has an illuminance of π L.
 */
export class IlluminancePicture {
  readonly farol: FarolRenderer;
  private readonly target = new WebGLRenderTarget(1, 1, { type: HalfFloatType });
  private readonly white = new MeshPhysicalMaterial({ roughness: 1, specularIntensity: 0, fog: false });
  private readonly shown = new RawShaderMaterial({
    name: 'Editor false colours',
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: {
      picture: { value: this.target.texture },
      stops: { value: illuminanceStops.map(([, hex]) => encoded(hex)) },
    },
    depthTest: false,
    depthWrite: false,
  });
  private readonly quad = new Mesh(new PlaneGeometry(2, 2), this.shown);
  private readonly scene = new ThreeScene();
  private readonly camera = new OrthographicCamera();
  private readonly endLost: () => void;

  /** @param redraw - called when a frame must be drawn, since late code has arrived */
  constructor(
    private readonly webgl: WebGLRenderer,
    redraw: () => void,
  ) {
    this.farol = new FarolRenderer(webgl);
    this.farol.addEventListener('redraw', redraw);
    this.quad.frustumCulled = false;
    this.scene.add(this.quad);
    this.endLost = whenLost(webgl, () => this.target.dispose());
  }

  /** Draws the scene in white to a render target of the canvas's size. */
  draw(scene: Scene, camera: Camera): void {
    const { webgl, target, farol } = this;
    const { three } = scene;
    const { overrideMaterial, background, fog } = three;
    const before = webgl.getRenderTarget();
    webgl.getDrawingBufferSize(size);
    target.setSize(size.x, size.y);
    followEffects(farol, scene, () => {});
    three.overrideMaterial = this.white;
    three.background = black;
    three.fog = null;
    webgl.setRenderTarget(target);
    try {
      farol.render(three, camera);
    } finally {
      webgl.setRenderTarget(before);
      Object.assign(three, { overrideMaterial, background, fog });
    }
  }

  /** Draws the false colours of the last picture to the bound target. */
  show(): void {
    this.webgl.render(this.scene, this.camera);
  }

  /**
   * Illuminance (lx) at a point of the last picture; null when the context is lost.
   * @param x - from the left edge, 0 to 1 @param y - from the lower edge, 0 to 1
   */
  async readAt(x: number, y: number): Promise<number | null> {
    const { target, webgl } = this;
    const at = (share: number, count: number): number => Math.min(count - 1, Math.max(0, Math.floor(share * count)));
    const pixel = new Uint16Array(4);
    if (!(await readPixels(webgl, target, at(x, target.width), at(y, target.height), 1, 1, pixel))) return null;
    const [r, g, b] = [...pixel].map((half) => DataUtils.fromHalfFloat(half));
    return Math.PI * (0.2126 * r + 0.7152 * g + 0.0722 * b);
  }

  dispose(): void {
    this.endLost();
    this.farol.dispose();
    this.target.dispose();
    this.white.dispose();
    this.shown.dispose();
    this.quad.geometry.dispose();
  }
}

function encoded(hex: string): Vector3 {
  const { r, g, b } = new Color(hex).getRGB({ r: 0, g: 0, b: 0 }, SRGBColorSpace);
  return new Vector3(r, g, b);
}
