export { FarolPass } from './FarolPass';
