import { expect, test } from '../support/test';

// the layer of the emulated headset is as large as the window
test.use({ viewport: { width: 192, height: 96 } });

test('in a headset each eye has fog of its own, which is that of a camera in its place @verify', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}xr.html`);
  await page.waitForFunction(() => 'xrPage' in window);
  const found = await page.evaluate(async () => {
    const { XRBench, compareImages, device, effects, eyeOf, isFlat, three } = window.xrPage;
    const bench = new XRBench();
    const { farol, webgl } = bench;
    const scene = new three.Scene();
    scene.background = new three.Color(0.05, 0.1, 0.2);
    const floor = new three.Mesh(new three.PlaneGeometry(20, 20), new three.MeshLambertMaterial());
    floor.rotation.x = -Math.PI / 2;
    const lamp = new three.PointLight(0xffaa66, 12, 8);
    lamp.position.set(0.4, 1.6, -2);
    scene.add(floor, lamp);
    const camera = new three.PerspectiveCamera(70, 1, 0.1, 50);
    const fog = new effects.VolumetricFog();
    Object.assign(fog, { density: 0.12, distance: 14, time: 0, frames: 1, froxels: [32, 32, 32] });
    farol.effects = [fog];
    await bench.start('immersive-vr');
    device.position.set(0.1, 1.5, 0.2);
    device.ipd = 1;
    const draw = async () => {
      await bench.settle('clustered-forward', scene, camera);
      return bench.frame(() => bench.layer(() => farol.render(scene, camera)));
    };
    const eyes = await draw();
    farol.effects = [];
    const without = await draw();
    farol.effects = [fog];
    await bench.settle('clustered-forward', scene, camera);
    const alone = await bench.frame(() => {
      const cameras = webgl.xr.getCamera().cameras.map((seen) => {
        const eye = new three.PerspectiveCamera();
        eye.matrixAutoUpdate = eye.matrixWorldAutoUpdate = false;
        eye.projectionMatrix.copy(seen.projectionMatrix);
        eye.projectionMatrixInverse.copy(seen.projectionMatrixInverse);
        eye.matrixWorld.copy(seen.matrixWorld);
        eye.matrixWorldInverse.copy(seen.matrixWorldInverse);
        return { eye, viewport: (seen as unknown as { viewport: InstanceType<typeof three.Vector4> }).viewport };
      });
      return bench.layer(() => {
        const layer = webgl.getRenderTarget()!;
        const whole = layer.viewport.clone();
        webgl.xr.enabled = false;
        layer.scissorTest = true;
        for (const { eye, viewport } of cameras) {
          layer.viewport.copy(viewport);
          layer.scissor.copy(viewport);
          webgl.setRenderTarget(layer);
          farol.render(scene, eye);
        }
        layer.scissorTest = false;
        layer.viewport.copy(whole);
        webgl.setRenderTarget(layer);
        webgl.xr.enabled = true;
      });
    });
    await bench.end();
    return ([0, 1] as const).map((eye) => ({
      flat: isFlat(eyeOf(eyes, eye)),
      shown: compareImages(eyeOf(eyes, eye), eyeOf(without, eye)).psnr,
      alone: compareImages(eyeOf(eyes, eye), eyeOf(alone, eye)).psnr,
    }));
  });
  for (const { flat, shown, alone } of found) {
    expect(flat).toBe(false);
    expect(shown).toBeLessThan(30);
    expect.soft(alone).toBeGreaterThan(50);
  }
});
