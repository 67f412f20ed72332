import type { Competitor } from './Competitor';
import { rivalCompetitor } from './rivals/rivalCompetitor';

/** Other engines: their code is fetched when they are chosen, and installed by `npm run rivals`. */
export const rivals: readonly Competitor[] = [
  rivalCompetitor({ name: 'playcanvas', engine: 'PlayCanvas' }),
  rivalCompetitor({ name: 'babylon', engine: 'Babylon.js' }),
];
