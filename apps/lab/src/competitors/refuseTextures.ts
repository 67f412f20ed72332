import type { Material } from 'three';
import type { StageScene } from '../stage/StageScene';

/**
 * Refuses a scene whose shadow maps and material textures exceed the texture limit of a shader.
 *
 * @param textures - maximum number of textures of a shader on this device
 * @param others - number of textures that the renderer itself binds in each shader
 * @throws Error with the number of lights whose shadow maps fit
 */
export function refuseTextures({ three, lights, still }: StageScene, textures: number, others = 0): void {
  const shadows = [...lights, ...still].filter(({ castShadow }) => castShadow).length;
  if (shadows === 0) return;
  let most = 0;
  three.traverse((object) => {
    const { material } = object as { material?: Material | Material[] };
    for (const each of [material ?? []].flat()) most = Math.max(most, texturesOf(each));
  });
  const room = textures - others - most - (three.environment ? 1 : 0);
  if (shadows <= room) return;
  throw new Error(
    `A shader holds ${textures} textures here, and ${textures - room} of them are in use: room for the shadow maps of ` +
      `${Math.max(0, room)} lights, not of ${shadows}.`,
  );
}

const texturesOf = (material: Material): number =>
  Object.values(material).filter((value) => (value as { isTexture?: boolean } | null)?.isTexture).length;
