import { expect, test } from '../support/benchTest';

/**
 * The light of thesis 3.2.5.3 by every technique: a white Lambert floor faces a light 2 m above it, seen from above, so that
 * radiance right below is colour × attenuation / π (and ambient adds without N·L).
 */
test('attenuations, cutoff exponent and separate colours of the thesis, by every technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(33, 33);
    const camera = new three.OrthographicCamera(-2, 2, 2, -2, 0.1, 10);
    camera.position.z = 5;
    const lights: Record<
      string,
      { spot?: boolean; data: import('@farol/renderer/light-options').FarolLightData; x?: number }
    > = {
      'near-far, between': { data: { attenuation: { kind: 'near-far', near: 1, far: 5 } } },
      'near-far, before near': { data: { attenuation: { kind: 'near-far', near: 3, far: 5 } } },
      'near-far, beyond far': { data: { attenuation: { kind: 'near-far', near: 0.5, far: 1.9 } } },
      polynomial: {
        data: { attenuation: { kind: 'polynomial', constant: 1, linear: 0.5, quadratic: 0.25, range: 10 } },
      },
      'polynomial, out of range': {
        data: { attenuation: { kind: 'polynomial', constant: 1, linear: 0, quadratic: 0, range: 1.9 } },
      },
      'spot, on its axis': {
        spot: true,
        data: { spotExponent: 8, attenuation: { kind: 'near-far', near: 3, far: 5 } },
      },
      'spot, off its axis': {
        spot: true,
        x: 1,
        data: { spotExponent: 8, attenuation: { kind: 'near-far', near: 3, far: 5 } },
      },
      ambient: { data: { ambient: [0.25, 0, 0], attenuation: { kind: 'near-far', near: 3, far: 5 } } },
    };
    const pixel = (data: Float32Array, x: number) =>
      Array.from(data.slice(4 * (16 * 33 + 16 + x), 4 * (16 * 33 + 16 + x) + 3));
    return techniquesInTurn(3).map((technique) => {
      const seen: Record<string, number[]> = {};
      for (const [name, { spot, data, x }] of Object.entries(lights)) {
        const scene = new three.Scene();
        scene.add(new three.Mesh(new three.PlaneGeometry(4, 4), new three.MeshLambertMaterial()));
        const light = spot ? new three.SpotLight(0xffffff, 1, 0, 0.7) : new three.PointLight(0xffffff, 1);
        light.position.set(0, 0, 2);
        light.userData.farol = data;
        scene.add(light);
        // eight pixels are a metre, nearly: 33 / 4
        seen[name] = pixel(bench.byTechnique(technique, scene, camera).data, x ? 8 : 0);
      }
      const shiny = new three.Scene();
      const phong = new three.MeshPhongMaterial({ color: 0x000000, specular: 0xffffff, shininess: 10 });
      shiny.add(new three.Mesh(new three.PlaneGeometry(4, 4), phong));
      const lamp = new three.PointLight(0xff0000, 1);
      lamp.position.z = 2;
      lamp.userData.farol = { specular: [0, 0.5, 0], attenuation: { kind: 'near-far', near: 3, far: 5 } };
      shiny.add(lamp);
      seen.specular = pixel(bench.byTechnique(technique, shiny, camera).data, 0);
      const sun = new three.DirectionalLight(new three.Color(0.5, 0.25, 0), 2);
      sun.position.set(0, 0, 2);
      sun.userData.farol = { specular: [0, 0.5, 1], ambient: [0, 0, 0.25] };
      const plain = new three.Mesh(new three.PlaneGeometry(4, 4), new three.MeshLambertMaterial());
      seen.directional = pixel(bench.byTechnique(technique, new three.Scene().add(plain, sun), camera).data, 0);
      const mirror = new three.Mesh(new three.PlaneGeometry(4, 4), phong);
      seen['specular, directional'] = pixel(
        bench.byTechnique(technique, new three.Scene().add(mirror, sun), camera).data,
        0,
      );
      const tinted = new three.Scene();
      const factor = new three.MeshPhongMaterial({ specular: 0x000000 });
      factor.onBeforeCompile = (shader) => {
        shader.fragmentShader = `#define FAROL_AMBIENT_FACTOR vec3(0.0, 0.5, 2.0)\n${shader.fragmentShader}`;
      };
      const fill = new three.PointLight(0x000000, 1, 6);
      fill.position.z = 2;
      fill.userData.farol = { ambient: [0.5, 0.5, 0.25], attenuation: { kind: 'near-far', near: 3, far: 5 } };
      tinted.add(new three.Mesh(new three.PlaneGeometry(4, 4), factor), fill);
      seen["material's ambient factor"] = pixel(bench.byTechnique(technique, tinted, camera).data, 0);
      return { technique, seen };
    });
  });
  // Off the axis: 8 pixels of 33 over 4 m are x = 0.9697 m; cos = 2 / |(x, 2)|; Lambert and cos^8.
  const cosine = 2 / Math.hypot((8 * 4) / 33, 2);
  const wanted: Record<string, [number, number, number]> = {
    'near-far, between': [0.75, 0.75, 0.75],
    'near-far, before near': [1, 1, 1],
    'near-far, beyond far': [0, 0, 0],
    polynomial: [1 / 3, 1 / 3, 1 / 3],
    'polynomial, out of range': [0, 0, 0],
    'spot, on its axis': [1, 1, 1],
    'spot, off its axis': [cosine ** 9, cosine ** 9, cosine ** 9],
    ambient: [1.25, 1, 1],
    "material's ambient factor": [0, 0.25, 0.5],
    // Blinn-Phong right below: F = 1, G = 1/4, D = (10 / 2 + 1) / π
    specular: [0, 0.5 * 1.5, 0],
    directional: [1, 0.5, 0.5],
    'specular, directional': [0, 1.5, 3],
  };
  // inferred lighting takes its light at half the resolution, half a pixel beside
  for (const { technique, seen } of results) {
    for (const [name, colour] of Object.entries(wanted)) {
      for (let c = 0; c < 3; c++) {
        expect(
          Math.abs(seen[name][c] * Math.PI - colour[c]),
          `${technique}, ${name}, channel ${c}: ${seen[name]}`,
        ).toBeLessThan((technique as string) === 'inferred' ? 0.05 : 0.006);
      }
    }
  }
});
