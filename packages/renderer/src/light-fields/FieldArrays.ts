import type { Texture, WebGLRenderer } from 'three';
import type { LightField } from './LightField';
import { FieldArray } from './FieldArray';
import type { FieldSources } from './FieldLights';

interface Arrays {
  readonly spheres: FieldArray;
  readonly emissions: FieldArray;
  readonly cones: FieldArray | null;
  /** Textures of the field, set in each frame. */
  readonly sources: FieldSources;
}

/** Textures of each field's arrays for one renderer, kept until the field is disposed. */
export class FieldArrays {
  private readonly known = new Map<LightField, Arrays>();
  private heldCount = 0;
  private readonly fieldSources: FieldSources = { sphere: null, emission: null, cone: null, width: 1 };

  get bytes(): number {
    return this.heldCount;
  }

  /** Uploads a field's changes. @param rows - number of rows of 128 lights @returns bytes uploaded */
  upload(webgl: WebGLRenderer, field: LightField, rows: number): number {
    if (field.textures !== null) return 0;
    const { spheres, emissions, cones } = this.known.get(field) ?? this.make(field);
    spheres.upload(webgl, rows);
    emissions.upload(webgl, rows);
    cones?.upload(webgl, rows);
    return spheres.uploadedBytes + emissions.uploadedBytes + (cones?.uploadedBytes ?? 0);
  }

  /** Textures of a field's lights. Call after `upload`. */
  sourcesOf(field: LightField): FieldSources {
    const { textures } = field;
    if (textures !== null) {
      this.fieldSources.sphere = textures.sphere;
      this.fieldSources.emission = textures.emission;
      this.fieldSources.cone = textures.cone ?? null;
      this.fieldSources.width = widthOf(textures.sphere);
      return this.fieldSources;
    }
    const { spheres, emissions, cones, sources } = this.known.get(field)!;
    sources.sphere = spheres.texture;
    sources.emission = emissions.texture;
    sources.cone = cones?.texture ?? null;
    return sources;
  }

  dispose(): void {
    for (const field of this.known.keys()) this.free(field);
  }

  private make(field: LightField): Arrays {
    const { spheres, emissions, cones } = field;
    const arrays = {
      spheres: new FieldArray(spheres),
      emissions: new FieldArray(emissions),
      cones: cones === null ? null : new FieldArray(cones),
      sources: { sphere: null, emission: null, cone: null, width: 128 },
    };
    this.known.set(field, arrays);
    this.heldCount += bytesOf(arrays);
    field.addEventListener('dispose' as never, this.forget);
    return arrays;
  }

  private readonly forget = (event: unknown): void => this.free((event as { target: LightField }).target);

  private free(field: LightField): void {
    const arrays = this.known.get(field)!;
    for (const array of [arrays.spheres, arrays.emissions, arrays.cones]) array?.dispose();
    this.heldCount -= bytesOf(arrays);
    this.known.delete(field);
    field.removeEventListener('dispose' as never, this.forget);
  }
}

function bytesOf({ spheres, emissions, cones }: Arrays): number {
  return spheres.bytes + emissions.bytes + (cones?.bytes ?? 0);
}

function widthOf({ image }: Texture): number {
  return Math.max(1, (image as { width: number }).width);
}
