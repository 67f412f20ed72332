import { shortText } from '@farol/editing';
import { storeLightOptions } from '@farol/renderer/light-options';
import { parseIES, PhotometricProfile } from '@farol/renderer/light-profiles';
import { Group, PointLight } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';
import { GltfLists } from '../guard/gltf/GltfLists';
import { LIGHTS_IES } from '../guard/gltf/readGltfJson';

const dataPattern = /^data:[^,]*?(;base64)?,(.*)$/is;

function textOfData(uri: string): string | null {
  const [, base64, data] = dataPattern.exec(uri) ?? [];
  if (data === undefined) return null;
  return base64 ? atob(data) : decodeURIComponent(data);
}

/**
 * Lights of a glTF that have a photometric profile: each becomes a PointLight below its node, in the orientation that
 * `setLightOptions` expects, with the profile's candelas.
 * @see EXT_lights_ies
 */
export class LightsIes implements GLTFLoaderPlugin {
  readonly name = LIGHTS_IES;
  /** Profiles of the file, in the file's order. */
  profiles: readonly PhotometricProfile[] = [];
  private readonly lists: GltfLists;

  constructor(private readonly parser: GLTFParser) {
    this.lists = new GltfLists(parser.json as ConstructorParameters<typeof GltfLists>[0]);
  }

  /** @throws Error (as a rejection) that says which profile cannot be read, and why */
  async beforeRoot(): Promise<void> {
    const { lists } = this;
    const extension = lists.record(lists.record((lists.json as { extensions?: unknown }).extensions)[LIGHTS_IES]);
    const lights = lists.listOf(extension.lights ?? [], `'lights' of ${LIGHTS_IES}`);
    this.profiles = await Promise.all(lights.map((light, i) => this.read(lists.record(light), i)));
  }

  createNodeAttachment(index: number): Promise<Group> | null {
    const node = this.lists.all('nodes')[index];
    const given = this.lists.record(node.extensions)[LIGHTS_IES];
    return given === undefined ? null : Promise.resolve(this.attachment(this.lists.record(given), node, index));
  }

  private async read(light: Record<string, unknown>, i: number): Promise<PhotometricProfile> {
    const lists: GltfLists = this.lists;
    const who = `light profile ${i}`;
    let text: string | null;
    if (typeof light.uri === 'string') {
      text = textOfData(light.uri);
      if (text === null) lists.fail(`${who} is in another file, ${shortText(light.uri, 80)}`);
    } else {
      const view = lists.index(light.bufferView, 'bufferViews', who);
      // decoded as Latin-1, in which makers' names often are
      text = new TextDecoder('latin1').decode((await this.parser.getDependency('bufferView', view)) as ArrayBuffer);
    }
    let profile: PhotometricProfile;
    try {
      profile = new PhotometricProfile(parseIES(text));
    } catch (error) {
      lists.fail(`${who} cannot be read (${(error as Error).message})`);
    }
    if (typeof light.name === 'string') profile.name = light.name;
    return profile;
  }

  private attachment(given: Record<string, unknown>, node: Record<string, unknown>, index: number): Group {
    const lists: GltfLists = this.lists;
    const { profiles } = this;
    const { light: which, multiplier = 1, color = [1, 1, 1] } = given;
    const profile = profiles[which as number];
    if (!profile)
      lists.fail(`node ${index} names the light profile ${lists.show(which)}, and there are ${profiles.length}`);
    const isAmount = (value: unknown): value is number => typeof value === 'number' && value >= 0 && value < 1e9;
    if (!isAmount(multiplier)) lists.fail(`the multiplier of node ${index} is ${lists.show(multiplier)}`);
    if (!Array.isArray(color) || color.length !== 3 || !color.every(isAmount))
      lists.fail(`the color of node ${index} is ${lists.show(color)}`);
    const light = new PointLight(0xffffff, multiplier * profile.maximumIntensity);
    light.color.setRGB(...(color as [number, number, number]));
    light.name = profile.name;
    // glTF aims luminaires along -z; three's point lights with profiles point along -y
    light.rotation.x = Math.PI / 2;
    storeLightOptions(light, { profile: profile.texture });
    const { farolLight } = lists.record(node.extras);
    if (farolLight !== undefined) light.userData.farolLight = farolLight;
    return new Group().add(light);
  }
}
