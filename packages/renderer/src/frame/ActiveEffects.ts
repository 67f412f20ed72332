import type { GBufferAttachment } from '../gbuffer/gbufferLayout';
import type { FarolEffect } from './FarolEffect';
import type { TwinAdapter } from './TwinAdapter';

const NOTHING: readonly never[] = [];

/** Effects of a frame, with their requests as lists; a new object when the host's list changes. */
export interface ActiveEffects {
  readonly all: readonly FarolEffect[];
  /** Effects that may replace the kind of twin (Farol's material for the host's) of a draw. */
  readonly adapters: readonly TwinAdapter[];
  /** G-buffer attachments of the effects, as many as the device has room for. */
  readonly attachments: readonly GBufferAttachment[];
  /** Whether an effect works on a G-buffer. */
  readonly needsSurfaces: boolean;
}

export const NO_EFFECTS: ActiveEffects = {
  all: NOTHING,
  adapters: NOTHING,
  attachments: NOTHING,
  needsSurfaces: false,
};

/** @param room - number of attachments that the device can draw to besides those of the G-buffer */
export function activeEffects(all: readonly FarolEffect[], room: number): ActiveEffects {
  return {
    all,
    adapters: all.filter((effect): effect is FarolEffect & TwinAdapter => effect.adapt !== undefined),
    attachments: all.flatMap(({ attachments = [] }) => attachments).slice(0, room),
    needsSurfaces: all.some((effect) => effect.needsSurfaces === true),
  };
}

/** Texts of the effect's claims, to follow "both" in a message. */
function claimsOf({ replaces, attachments = [], movesCamera = false }: FarolEffect): string[] {
  return [
    ...(replaces === undefined ? [] : [`draw "${replaces}" in place of the technique`]),
    ...attachments.map(({ name }) => `add the attachment "${name}" to the G-buffer`),
    ...(movesCamera ? ['move the camera'] : []),
  ];
}

/** @throws Error that names two effects that cannot draw one frame together, or for a value that is no list of effects */
export function refuseConflicts(effects: readonly FarolEffect[]): void {
  // JavaScript hosts may set a single effect, a class or a name
  if (!Array.isArray(effects) || !effects.every((effect: Partial<FarolEffect> | null) => effect?.dispose))
    throw new Error('Farol: effects is not a list of effects; give one, such as [new TAA()].');
  const owners = new Map<string, FarolEffect>();
  for (const effect of effects) {
    for (const claim of claimsOf(effect)) {
      const owner = owners.get(claim);
      if (owner !== undefined)
        throw new Error(
          `Farol: the effects "${owner.name}" and "${effect.name}" both ${claim}; leave one of them out.`,
        );
      owners.set(claim, effect);
    }
  }
}
