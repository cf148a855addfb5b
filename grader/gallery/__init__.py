"""What can be seen of a submission: pictures beside Mitsuba's, trees and rays in space."""
