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
import { whenLost } from './whenLost';

/** Height of the small picture (CSS pixels), and its largest width. */
const HEIGHT = 130;
const WIDEST = 260;
const MARGIN = 10;

/** Where the small picture is, from the right lower corner of the large one (CSS pixels). */
export interface PreviewPlace {
  readonly width: number;
  readonly height: number;
  readonly margin: number;
}

/** What a camera of the scene sees, as a small picture in a corner of the large one. Made when it is first asked for. */
export class CameraPreview {
  private readonly farol: FarolRenderer;
  private readonly picture: PictureRenderer;
  private readonly target: WebGLRenderTarget;
  private readonly endLost: () => void;
  private readonly quad: Mesh<PlaneGeometry, MeshBasicMaterial>;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly viewport = new Vector4();
  /** What the small picture was drawn of. */
  private drawnOf = '';

  /** @param redraw - called when the small picture is to be drawn anew */
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

  /** What it draws with. */
  get microshaders(): MicroShaderRegistry {
    return this.farol.microshaders;
  }

  /** Its place in a picture of a size (CSS pixels), by the form that the camera is given. */
  static placeIn(width: number, height: number): PreviewPlace {
    const small = Math.min(HEIGHT, height / 3);
    return { width: Math.round(Math.min(WIDEST, (small * width) / height)), height: Math.round(small), margin: MARGIN };
  }

  /**
   * Draws it over the picture.
   * @param width - of the large picture (CSS pixels)
   * @param height - of the large picture (CSS pixels)
   * @param key - differs whenever the camera may see something else; the small picture is drawn anew only then
   */
  render(scene: EngineScene, camera: CameraComponent, width: number, height: number, key: string): void {
    const { webgl } = this;
    const place = CameraPreview.placeIn(width, height);
    const ratio = webgl.getPixelRatio();
    const wanted = `${camera.id} ${place.width} ${place.height} ${ratio} ${key}`;
    this.target.setSize(Math.round(place.width * ratio), Math.round(place.height * ratio));
    const { autoClear } = webgl;
    const before = webgl.getRenderTarget();
    webgl.getViewport(this.viewport);
    if (wanted !== this.drawnOf) {
      this.drawnOf = wanted;
      camera.setViewport(place.width, place.height);
      webgl.setRenderTarget(this.target);
      webgl.autoClear = true;
      this.picture.render(scene, camera.three, camera);
      webgl.setRenderTarget(before);
    }
    webgl.autoClear = false;
    // counted from the lower left corner
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
