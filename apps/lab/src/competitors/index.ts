import type { Competitor } from './Competitor';
import type { CompetitorName } from './competitorNames';
import { techniques, type TechniqueName } from '@farol/renderer';
import { farol } from './farol';
import { multipass } from './multipass';
import type { RivalName } from './rivals/rivalCompetitor';
import { stock } from './stock';

/** Fetches a competitor's code. */
type Fetch = () => Promise<Competitor>;

const farolCompetitors = Object.fromEntries(
  Object.keys(techniques).map((name) => [name, async () => farol(name as TechniqueName)]),
) as Record<TechniqueName, Fetch>;

/** Another engine as a competitor, whose module is fetched when it draws. */
const rival = async (name: RivalName): Promise<Competitor> =>
  (await import('./rivals/rivalCompetitor')).rivalCompetitor(name);

/** Competitors by key; large ones are fetched when they first draw. A new competitor needs a file and a line here. */
export const competitors: Readonly<Record<CompetitorName, Fetch>> = {
  ...farolCompetitors,
  lite: async () => farol('auto', 'lite'),
  stock: async () => stock,
  multipass: async () => multipass,
  'three-webgpu': async () => (await import('./threeWebGPU')).threeWebGPU,
  playcanvas: () => rival('playcanvas'),
  babylon: () => rival('babylon'),
};

/** Fetches a competitor. @throws Error (as a rejection) for an unknown name */
export async function loadCompetitor(name: string): Promise<Competitor> {
  const load = Object.hasOwn(competitors, name) ? competitors[name as CompetitorName] : undefined;
  if (!load) throw new Error(`There is no competitor ‘${name}’: choose one of ${Object.keys(competitors).join(', ')}.`);
  return load();
}
