/** English names of the library's items by group and id. The Add menu lists them before their data are fetched. */
export const libraryNames = {
  lamp: {
    'street-lamp': 'Street lamp',
    lantern: 'Lantern',
    torch: 'Torch',
    candle: 'Candle',
    pendant: 'Pendant lamp',
    'desk-lamp': 'Desk lamp',
    'neon-tube': 'Neon tube',
    panel: 'Light panel',
    'rail-spots': 'Spots on a rail',
    chandelier: 'Chandelier',
    'fairy-lights': 'Fairy lights',
    sconce: 'Sconce',
    floodlight: 'Floodlight',
    headlamps: 'Headlamps',
    'daylight-window': 'Window with daylight',
  },
  prop: {
    street: 'Street',
    tree: 'Tree',
    fir: 'Fir',
    bench: 'Bench',
    table: 'Table##furniture',
    chair: 'Chair',
    crate: 'Crate',
    barrel: 'Barrel',
    'plain-wall': 'Plain wall',
    fence: 'Fence',
    column: 'Column',
    steps: 'Steps',
    ground: 'Ground',
  },
  play: {
    player: 'Player',
    door: 'Door',
    zone: 'Zone',
    flicker: 'Flicker',
    follow: 'Follow',
    patrol: 'Patrol',
  },
  sky: {
    'clear-day': 'Clear day',
    overcast: 'Overcast',
    sunset: 'Sunset',
    'moonlit-night': 'Moonlit night',
    'foggy-night': 'Foggy night',
    studio: 'Studio',
  },
} as const;

/** Groups whose items are prefabs. */
export type PrefabGroup = 'lamp' | 'prop' | 'play';
export type LibraryGroup = keyof typeof libraryNames;
export type LibraryId = { [G in LibraryGroup]: keyof (typeof libraryNames)[G] }[LibraryGroup];
