import { play } from './play';
import { runScripts } from './runScripts';

play(runScripts);
