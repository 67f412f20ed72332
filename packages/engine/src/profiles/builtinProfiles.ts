import type { PhotometricProfile } from '@farol/renderer/light-profiles';

/** An asset of type 'profile', made on first use. */
export interface ProfileSource {
  readonly type: 'profile';
  load(): Promise<PhotometricProfile>;
}

const made = (name: 'downlight' | 'wallWasher' | 'streetLight'): ProfileSource => ({
  type: 'profile',
  load: async () => (await import('./makeProfile')).makeProfile(name),
});

/** Photometric profiles of every library: typical luminaires, of no particular maker. */
export const builtinProfiles: Readonly<Record<string, ProfileSource>> = {
  'profile/downlight': made('downlight'),
  'profile/wall-washer': made('wallWasher'),
  'profile/street-light': made('streetLight'),
};
