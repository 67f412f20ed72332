import { play } from './play';

play(null);
