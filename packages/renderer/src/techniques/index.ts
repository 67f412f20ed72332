import { auto } from './auto';
import { clusteredDeferred } from './clusteredDeferred';
import { clusteredForward } from './clusteredForward';
import { deferred } from './deferred';
import { forward } from './forward';
import { forwardPlus } from './forwardPlus';
import { forwardSinglePass } from './forwardSinglePass';
import { inferred } from './inferred';
import { lightPrepass } from './lightPrepass';
import { tiledDeferred } from './tiledDeferred';
import { tiledForward } from './tiledForward';
import type { Technique } from '../frame/Technique';

/** All techniques by name. A new technique is a file and a line here. */
export const techniques = {
  auto,
  forward,
  'forward-single-pass': forwardSinglePass,
  deferred,
  'light-prepass': lightPrepass,
  inferred,
  'tiled-deferred': tiledDeferred,
  'tiled-forward': tiledForward,
  'forward-plus': forwardPlus,
  'clustered-deferred': clusteredDeferred,
  'clustered-forward': clusteredForward,
} as const satisfies Record<string, Technique>;

/** Names of the techniques that Farol has. */
export type TechniqueName = keyof typeof techniques;
