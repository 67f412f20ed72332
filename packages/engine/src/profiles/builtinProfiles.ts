import type { AssetSource } from '../assets/Asset';

const made = (name: 'downlight' | 'wallWasher' | 'streetLight'): AssetSource => ({
  type: 'profile',
  load: async () => (await import('./makeProfile')).makeProfile(name),
});

/** Photometric profiles that every library knows: luminaires that nobody makes, as typical ones of their kind. */
export const builtinProfiles: Readonly<Record<string, AssetSource>> = {
  'profile/downlight': made('downlight'),
  'profile/wall-washer': made('wallWasher'),
  'profile/street-light': made('streetLight'),
};
