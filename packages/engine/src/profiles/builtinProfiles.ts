import type { PhotometricProfile } from '@farol/renderer/light-profiles';

/** An asset of type 'profile', made when it is first needed. */
export interface ProfileSource {
  readonly type: 'profile';
  load(): Promise<PhotometricProfile>;
}

const made = (name: 'downlight' | 'wallWasher' | 'streetLight'): ProfileSource => ({
  type: 'profile',
  load: async () => (await import('./makeProfile')).makeProfile(name),
});

/** Photometric profiles that every library knows: luminaires that nobody makes, as typical ones of their kind. */
export const builtinProfiles: Readonly<Record<string, ProfileSource>> = {
  'profile/downlight': made('downlight'),
  'profile/wall-washer': made('wallWasher'),
  'profile/street-light': made('streetLight'),
};
