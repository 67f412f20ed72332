import type { Camera, Light, Object3D, Scene, WebGLRenderer, WebGLShadowMap } from 'three';

/**
 * Takes the place of three's `shadowMap.render` while a frame is drawn: Farol's maps are drawn after three's own. A render by
 * stock three inside the frame (three's `Reflector`, `Water`) turns `autoUpdate` off, since it takes the frame to have drawn
 * three's maps; Farol's frame has not, so such a render gets the host's own `autoUpdate` back.
 */
export class ShadowMapCalls {
  /** Scene as the frame passes it to three, see `SceneView`. */
  private scene: Object3D | null = null;
  /** three makes another one when a lost context is restored. */
  private shadowMap: WebGLShadowMap;
  private threeRender: WebGLShadowMap['render'];
  private autoUpdate = true;
  private fail!: (error: unknown) => void;

  /** @param draw - draws Farol's maps */
  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly draw: () => void,
  ) {
    this.shadowMap = webgl.shadowMap;
    this.threeRender = webgl.shadowMap.render;
  }

  /**
   * @param scene - as the frame shows it to three, see `SceneView`
   * @param fail - gets what is thrown while the frame's own maps are drawn
   */
  begin(scene: Object3D, fail: (error: unknown) => void): void {
    const { shadowMap } = this.webgl;
    this.scene = scene;
    this.fail = fail;
    this.shadowMap = shadowMap;
    this.threeRender = shadowMap.render;
    this.autoUpdate = shadowMap.autoUpdate;
    shadowMap.render = this.render;
  }

  end(): void {
    this.shadowMap.render = this.threeRender;
  }

  private readonly render = (lights: Light[], scene: Scene, camera: Camera) => {
    const { shadowMap, webgl } = this;
    if (scene === this.scene) {
      const target = webgl.getRenderTarget();
      const face = webgl.getActiveCubeFace();
      const level = webgl.getActiveMipmapLevel();
      try {
        this.threeRender.call(shadowMap, lights, scene, camera);
        this.draw();
      } catch (error) {
        webgl.setRenderTarget(target, face, level);
        this.fail(error);
      }
      return;
    }
    const updates = shadowMap.autoUpdate;
    shadowMap.autoUpdate = this.autoUpdate;
    try {
      this.threeRender.call(shadowMap, lights, scene, camera);
    } finally {
      shadowMap.autoUpdate = updates;
    }
  };
}
