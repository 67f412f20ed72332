import { type Camera as CameraComponent, PictureRenderer, type Scene as EngineScene } from '@farol/engine';
import { FarolRenderer } from '@farol/renderer';
import type { MicroShaderRegistry } from '@farol/renderer/authoring';
import {
  type ColorSpace,
  HalfFloatType,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  PlaneGeometry,
  Scene,
  SRGBColorSpace,
  UnsignedByteType,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three';
import { drawsFloats } from './drawsFloats';
import { previewPlace } from './previewPlace';
import { whenLost } from './whenLost';

/** Inset in a corner of the viewport that shows the view of the selected camera. Created at first use. */
export class CameraPreview {
  private readonly farol: FarolRenderer;
  private readonly picture: PictureRenderer;
  private readonly target: WebGLRenderTarget;
  private readonly endLost: () => void;
  private readonly quad: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly viewport = new Vector4();
  /** Key of the last rendered image, see `render`. */
  private drawnOf = '';

  /** @param redraw - called when the inset must be rendered again */
  constructor(
    private readonly webgl: WebGLRenderer,
    redraw: () => void,
  ) {
    const colours = drawsFloats(webgl)
      ? { type: HalfFloatType }
      : { type: UnsignedByteType, colorSpace: SRGBColorSpace as ColorSpace };
    this.target = new WebGLRenderTarget(1, 1, { ...colours, samples: 4 });
    this.endLost = whenLost(webgl, () => {
      this.target.dispose();
      this.drawnOf = '';
    });
    this.farol = new FarolRenderer(webgl, { technique: 'forward-single-pass' });
    const again = (): void => {
      this.drawnOf = '';
      redraw();
    };
    this.picture = new PictureRenderer(this.farol, { redraw: again, followsRendering: false });
    const material = new MeshBasicMaterial({
      map: this.target.texture,
      depthTest: false,
      depthWrite: false,
      fog: false,
    });
    this.quad = new Mesh(new PlaneGeometry(2, 2), material);
    this.quad.frustumCulled = false;
    this.quad.position.z = -1;
    this.scene.add(this.quad);
  }

  /** Microshaders of the preview's renderer. */
  get microshaders(): MicroShaderRegistry {
    return this.farol.microshaders;
  }

  /**
   * Draws the inset over the viewport.
   * @param width - viewport width (CSS pixels)
   * @param height - viewport height (CSS pixels)
   * @param key - changes whenever the camera may see something else; only then is the inset rendered again
   */
  render(scene: EngineScene, camera: CameraComponent, width: number, height: number, key: string): void {
    const { webgl } = this;
    const place = previewPlace(width, height);
    const ratio = webgl.getPixelRatio();
    const drawKey = `${camera.id} ${place.width} ${place.height} ${ratio} ${key}`;
    this.target.setSize(Math.round(place.width * ratio), Math.round(place.height * ratio));
    const { autoClear } = webgl;
    const previousTarget = webgl.getRenderTarget();
    webgl.getViewport(this.viewport);
    if (drawKey !== this.drawnOf) {
      this.drawnOf = drawKey;
      camera.setViewport(place.width, place.height);
      webgl.setRenderTarget(this.target);
      webgl.autoClear = true;
      this.picture.render(scene, camera.three, camera);
      webgl.setRenderTarget(previousTarget);
    }
    webgl.autoClear = false;
    // WebGL measures y from the lower edge
    webgl.setViewport(width - place.width - place.margin, place.margin, place.width, place.height);
    webgl.render(this.scene, this.camera);
    webgl.setViewport(this.viewport);
    webgl.autoClear = autoClear;
  }

  dispose(): void {
    this.endLost();
    this.picture.dispose();
    this.farol.dispose();
    this.target.dispose();
    this.quad.geometry.dispose();
    this.quad.material.dispose();
  }
}
