import { type PhotometricProfile, writeIES } from '@farol/renderer/light-profiles';
import type { Object3D } from 'three';

const NAME = 'EXT_lights_ies';
const MIME_TYPE = 'application/x-ies-lm-63';

/** A light with a photometric profile, as glTF stores it. */
export interface ProfileLight {
  readonly profile: PhotometricProfile;
  /** Factor on the profile's intensities (candela values). */
  readonly multiplier: number;
  /** Colour of the light (linear RGB, 0 to 1). */
  readonly color: readonly number[];
}

/** Parts of GLTFExporter's writer that profiles use. */
export interface ProfileWriter {
  readonly json: { extensions?: Record<string, unknown> };
  readonly extensionsUsed: Record<string, boolean>;
  processBufferViewImage(blob: Blob): Promise<number>;
}

interface WrittenProfile {
  readonly name?: string;
  readonly bufferView: number;
  readonly mimeType: typeof MIME_TYPE;
}

/** Writes lights with photometric profiles to glTF. @see EXT_lights_ies */
export class GltfProfiles {
  private readonly lights: WrittenProfile[] = [];
  private readonly indices = new Map<PhotometricProfile, number>();

  /** @param nodes - nodes with such lights */
  constructor(
    private readonly writer: ProfileWriter,
    private readonly nodes: ReadonlyMap<Object3D, ProfileLight>,
  ) {}

  /** Writes the profile of a node, before the node itself is written. */
  async prepare(object: Object3D): Promise<void> {
    const profile = this.nodes.get(object)?.profile;
    if (!profile || this.indices.has(profile)) return;
    const text = writeIES(profile);
    // padded with line ends to a multiple of four bytes, which parsers of the text ignore
    const bytes = Uint8Array.from(text.padEnd(4 * Math.ceil(text.length / 4), '\n'), (letter) => letter.charCodeAt(0));
    this.indices.set(profile, this.lights.length);
    const light = {
      bufferView: await this.writer.processBufferViewImage(new Blob([bytes])),
      mimeType: MIME_TYPE,
    } as const;
    this.lights.push(profile.name === '' ? light : { name: profile.name, ...light });
  }

  writeNode(object: Object3D, nodeDef: { extensions?: Record<string, unknown> }): void {
    const found = this.nodes.get(object);
    if (!found) return;
    const { profile, multiplier, color } = found;
    const isWhite = color.every((channel) => channel === 1);
    nodeDef.extensions = {
      ...nodeDef.extensions,
      [NAME]: {
        light: this.indices.get(profile),
        ...(multiplier === 1 ? {} : { multiplier }),
        ...(isWhite ? {} : { color }),
      },
    };
  }

  /** Lists the profiles in the file, once all nodes are written. */
  finish(): void {
    const { json, extensionsUsed } = this.writer;
    if (this.lights.length === 0) return;
    json.extensions = { ...json.extensions, [NAME]: { lights: this.lights } };
    extensionsUsed[NAME] = true;
  }
}
