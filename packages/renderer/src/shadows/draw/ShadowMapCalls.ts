import type { Camera, Light, Object3D, Scene, WebGLRenderer, WebGLShadowMap } from 'three';

/**
 * Replaces three's `shadowMap.render` while a frame is drawn: Farol's maps are drawn after three's own. Objects that render
 * inside a frame by stock three (three's `Reflector`, `Water`) turn `autoUpdate` off, assuming that the frame has drawn three's
 * maps. A Farol frame has not, so such a render gets the host's own `autoUpdate` back.
 */
export class ShadowMapCalls {
  /** Scene as the frame passes it to three, see `SceneView`. */
  private scene: Object3D | null = null;
  /** three's object, a new one after a lost context is restored. */
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
   * @param scene - stand-in that the frame passes to three, see `SceneView`
   * @param fail - called with errors thrown while the frame's maps are drawn
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
