import { readPixels } from '@farol/renderer/read-pixels';
import {
  AmbientLight,
  BackSide,
  BoxGeometry,
  DirectionalLight,
  type Material,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  PointLight,
  Scene,
  SphereGeometry,
  SRGBColorSpace,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { renderSmall } from './renderSmall';
import { whenLost } from './whenLost';
import { whenRestored } from './whenRestored';

/** Rotation of a preview ball (rad). */
export type BallTurn = readonly [right: number, up: number];

/**
 * Renders a sphere with a material to a canvas of the page, without waiting for the GPU. Uses the scene's material
 * itself, under lights of the preview.
 */
export class MaterialBall {
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 20);
  private readonly ball: Mesh;
  private readonly target = new WebGLRenderTarget(1, 1, { samples: 4 });
  private readonly ownMaterials: Material[] = [];
  private readonly endLost: () => void;
  private pixels = new Uint8Array(0);
  private isBusy = false;
  private isDisposed = false;
  private next: (() => void) | null = null;

  constructor(private readonly webgl: WebGLRenderer) {
    this.target.texture.colorSpace = SRGBColorSpace;
    this.ball = new Mesh(new SphereGeometry(1, 96, 64));
    const room = new MeshBasicMaterial({ color: 0x30343c, side: BackSide, toneMapped: false });
    this.ownMaterials.push(room);
    const key = new DirectionalLight(0xffffff, 2.4);
    key.position.set(-2, 3, 3);
    const rim = new PointLight(0x9db8ff, 14);
    rim.position.set(2.4, 1, -1.5);
    this.scene.add(this.ball, new Mesh(new BoxGeometry(12, 12, 12), room), key, rim, new AmbientLight(0xffffff, 0.35));
    this.camera.position.set(0, 0.5, 4.3);
    this.camera.lookAt(0, 0, 0);
    this.endLost = whenLost(webgl, () => this.free());
  }

  /**
   * Renders the sphere, retrying once after a lost context. When several calls arrive during rendering, only the last
   * one is carried out.
   * @param canvas - filled with the image
   * @param environment - environment map for reflections; null for none
   */
  async draw(
    material: Material,
    environment: Texture | null,
    canvas: HTMLCanvasElement,
    turn: BallTurn = [0, 0],
  ): Promise<void> {
    if (this.isBusy) {
      this.next = () => void this.draw(material, environment, canvas, turn);
      return;
    }
    this.isBusy = true;
    try {
      do await whenRestored(this.webgl);
      while (!this.isDisposed && !(await this.drawNow(material, environment, canvas, turn)));
    } finally {
      this.isBusy = false;
      const { next } = this;
      this.next = null;
      next?.();
    }
  }

  dispose(): void {
    this.isDisposed = true;
    this.next = null;
    this.endLost();
    this.free();
  }

  private free(): void {
    this.target.dispose();
    for (const child of this.scene.children) if (child instanceof Mesh) child.geometry.dispose();
    for (const material of this.ownMaterials) material.dispose();
  }

  /** Renders the sphere once. @returns false when the context was lost during rendering */
  private async drawNow(
    material: Material,
    environment: Texture | null,
    canvas: HTMLCanvasElement,
    [right, up]: BallTurn,
  ): Promise<boolean> {
    const { webgl, target } = this;
    const { width, height } = canvas;
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context) return true;
    this.ball.material = material;
    this.ball.rotation.set(up, right, 0);
    this.scene.environment = environment;
    target.setSize(width, height);
    const previousTarget = webgl.getRenderTarget();
    const { autoClear } = webgl;
    webgl.autoClear = true;
    webgl.setRenderTarget(target);
    renderSmall(webgl, this.scene, this.camera);
    webgl.setRenderTarget(previousTarget);
    webgl.autoClear = autoClear;
    this.scene.environment = null;
    if (this.pixels.length !== width * height * 4) this.pixels = new Uint8Array(width * height * 4);
    if (!(await readPixels(webgl, target, 0, 0, width, height, this.pixels))) return false;
    // WebGL rows start at the bottom
    const image = context.createImageData(width, height);
    const row = width * 4;
    for (let y = 0; y < height; y++) {
      image.data.set(this.pixels.subarray((height - 1 - y) * row, (height - y) * row), y * row);
    }
    context.putImageData(image, 0, 0);
    return true;
  }
}
