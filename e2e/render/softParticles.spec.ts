import { expect, test } from '../support/benchTest';

test('soft particles fade before surfaces where these lie, not where polygonOffset has shifted their depth, by every technique', async ({
  benchPage: page,
}) => {
  const rows = await page.evaluate(() => {
    const { Bench, compareImages, effects, oneParticle, techniquesInTurn, three } = window.testPage;
    const [width, height] = [96, 72];
    const bench = new Bench(width, height);
    bench.farol.inferredScale = 1;
    const scene = new three.Scene();
    const material = new three.MeshStandardMaterial({ color: 0x101010 });
    const floor = new three.Mesh(new three.PlaneGeometry(40, 40), material);
    floor.rotation.x = -Math.PI / 2;
    const fog = oneParticle({ size: [3, 3], softness: 0.8 });
    fog.position.set(0, 0.6, 0);
    fog.step(0.03);
    scene.add(floor, fog, new three.PointLight(0xffffff, 1, 1));
    const cameras = [
      new three.PerspectiveCamera(50, width / height, 0.1, 100),
      new three.OrthographicCamera(-2.4, 2.4, 1.8, -1.8, 0.1, 100),
    ];
    for (const camera of cameras) {
      camera.position.set(0, 1.4, 4);
      camera.lookAt(0, 0.4, 0);
    }
    bench.farol.effects = [new effects.Particles()];
    return cameras.flatMap((camera) =>
      techniquesInTurn(0).map((technique) => {
        const wanted = bench.byTechnique(technique, scene, camera);
        Object.assign(material, { polygonOffset: true, polygonOffsetFactor: 4, polygonOffsetUnits: 2 });
        const shifted = bench.byTechnique(technique, scene, camera);
        material.polygonOffset = false;
        fog.softness = 0;
        const hard = bench.byTechnique(technique, scene, camera);
        fog.softness = 0.8;
        return {
          name: `${technique}, ${camera.type}`,
          matters: compareImages(wanted, hard).psnr,
          psnr: compareImages(wanted, shifted).psnr,
        };
      }),
    );
  });
  for (const { name, matters, psnr } of rows) {
    expect(matters, `${name}: softness is to be seen`).toBeLessThan(30);
    expect.soft(psnr, name).toBeGreaterThan(55);
  }
});
