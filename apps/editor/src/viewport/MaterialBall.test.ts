import { Matrix4, type Mesh, MeshBasicMaterial, type Scene, SphereGeometry, Vector3, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { type BallTurn, MaterialBall } from './MaterialBall';

/** Position in the rendered picture of a point of the ball, after a rotation. */
async function turned(point: readonly [number, number, number], turn: BallTurn): Promise<number[]> {
  const drawn = new Matrix4();
  let wasDrawn = false;
  const stop = new Error('No pixels are read here.');
  const webgl = {
    domElement: new EventTarget(),
    autoClear: true,
    getContext: () => ({ isContextLost: () => false }),
    getRenderTarget: () => null,
    setRenderTarget: () => {},
    render: (scene: Scene) => {
      const ball = scene.children.find((each) => (each as Mesh).geometry instanceof SphereGeometry)!;
      ball.updateMatrixWorld();
      drawn.copy(ball.matrixWorld);
      wasDrawn = true;
      throw stop;
    },
  };
  const canvas = { width: 8, height: 8, getContext: () => ({}) } as unknown as HTMLCanvasElement;
  const ball = new MaterialBall(webgl as unknown as WebGLRenderer);
  await expect(ball.draw(new MeshBasicMaterial(), null, canvas, turn)).rejects.toBe(stop);
  ball.dispose();
  expect(wasDrawn).toBe(true);
  return new Vector3(...point).applyMatrix4(drawn).toArray();
}

it.each([
  ['stands without a turn', [0, 0], [0, 0, 1]],
  ['brings its front to the right about +Y', [Math.PI / 2, 0], [1, 0, 0]],
  ['brings its front to the left about -Y', [-Math.PI / 2, 0], [-1, 0, 0]],
  ['brings its front down about +X', [0, Math.PI / 2], [0, -1, 0]],
  ['turns about its own +Y before the +X of the view', [Math.PI / 2, Math.PI / 2], [1, 0, 0]],
] as const)('the ball %s', async (_what, turn, wanted) => {
  (await turned([0, 0, 1], turn)).forEach((value, i) => expect(value).toBeCloseTo(wanted[i], 10));
});
