export { FarolPass } from './FarolPass';
export type { FarolProps } from '../r3f/useFarolSettings';
